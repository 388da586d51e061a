#pragma once
// Files for a moment, removed whatever happens: a process that only waits for the end of this one removes them.
#include <string>

namespace burnish {

/// A process that makes a file or folder, and removes it as soon as this one ends, however and whenever it ends, or closes it.
class Remover {
public:
  /// @param pattern path whose last six letters before the extension are XXXXXX; those of the name that is made are others
  /// @param extension letters behind them, FOLDER: a folder is made, which has none
  /// @returns its path, "" if it cannot be made
  std::string make(const std::string& pattern, int extension);
  static constexpr int FOLDER = -1;
  /// Removes it now.
  void remove();

private:
  std::string m_path;
  int m_end = -1; // of a connection: the other process reads until it is closed
  int m_process = -1;
};

/// A file with a text, in the system's folder for temporary files.
class TemporaryFile {
public:
  /// @param extension  of its name, with the dot
  /// @throws std::invalid_argument if it cannot be made or written
  TemporaryFile(const std::string& text, const std::string& extension);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return m_path; }

private:
  Remover m_remover;
  std::string m_path;
};

/// An empty folder there; removed with all that is in it.
class TemporaryFolder {
public:
  /// @throws std::invalid_argument if it cannot be made
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return m_path; }

private:
  Remover m_remover;
  std::string m_path;
};

/// All bytes of a file; "" if it cannot be read.
std::string file_content(const std::string& path);

} // namespace burnish

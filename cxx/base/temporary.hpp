#pragma once
// Files for a moment, removed whatever happens: a process that only waits for the end of this one removes them.
#include <string>

namespace burnish {

/// A process that removes a file or folder as soon as this one ends, however it ends, or closes it.
class Remover {
public:
  void watch(const std::string& path);
  /// Removes it now.
  void remove();

private:
  std::string m_path;
  int m_end = -1; // of a pipe: the other process reads until it is closed
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
  std::string m_path;
  Remover m_remover;
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
  std::string m_path;
  Remover m_remover;
};

/// All bytes of a file; "" if it cannot be read.
std::string file_content(const std::string& path);

} // namespace burnish

#pragma once
// Files for a moment, removed whatever happens.
#include <string>

namespace burnish {

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
};

/// All bytes of a file; "" if it cannot be read.
std::string file_content(const std::string& path);

} // namespace burnish

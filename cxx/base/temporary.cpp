#include "base/temporary.hpp"
#include "base/error.hpp"
#include <filesystem>
#include <fstream>
#include <stdlib.h>
#include <unistd.h>

namespace burnish {

namespace {

std::string pattern(const std::string& extension) {
  std::error_code code;
  auto folder = std::filesystem::temp_directory_path(code);
  if (code) folder = "/tmp";
  return (folder / ("burnishXXXXXX" + extension)).string();
}

} // namespace

TemporaryFile::TemporaryFile(const std::string& text, const std::string& extension)
    : m_path(pattern(extension)) {
  const int handle = mkstemps(m_path.data(), static_cast<int>(extension.size()));
  if (handle < 0) fail("TemporaryFile", "no temporary file can be made as " + m_path);
  close(handle);
  std::ofstream stream(m_path, std::ios::binary);
  stream << text;
  stream.close();
  if (stream) return;
  std::error_code code;
  std::filesystem::remove(m_path, code);
  fail("TemporaryFile", m_path + " cannot be written: is the disk full?");
}

TemporaryFile::~TemporaryFile() {
  std::error_code code;
  std::filesystem::remove(m_path, code);
}

TemporaryFolder::TemporaryFolder() : m_path(pattern("")) {
  if (!mkdtemp(m_path.data())) fail("TemporaryFolder", "no temporary folder can be made as " + m_path);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code code;
  std::filesystem::remove_all(m_path, code);
}

std::string file_content(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

} // namespace burnish

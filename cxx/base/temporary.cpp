#include "base/temporary.hpp"
#include "base/error.hpp"
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <stdlib.h>
#include <sys/wait.h>
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

// The copy of this process shares all its files; it closes what it has no part in.
void Remover::watch(const std::string& path) {
  m_path = path;
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return;
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, &before); // Ctrl-C reaches both processes
  m_process = fork();
  if (m_process == 0) {
    setsid();
    close(ends[1]);
    dup2(ends[0], 0);
    close_range(1, ~0U, 0);
    char byte = 0;
    while (read(0, &byte, 1) < 0 && errno == EINTR) {
    }
    std::error_code code;
    std::filesystem::remove_all(path, code);
    _exit(0);
  }
  sigprocmask(SIG_SETMASK, &before, nullptr);
  close(ends[0]);
  m_end = ends[1];
}

void Remover::remove() {
  std::error_code code;
  std::filesystem::remove_all(m_path, code);
  if (m_end >= 0) close(m_end);
  m_end = -1;
  if (m_process > 0)
    while (waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) {
    }
  m_process = -1;
}

TemporaryFile::TemporaryFile(const std::string& text, const std::string& extension)
    : m_path(pattern(extension)) {
  const int handle = mkstemps(m_path.data(), static_cast<int>(extension.size()));
  if (handle < 0) fail("TemporaryFile", "no temporary file can be made as " + m_path);
  m_remover.watch(m_path);
  close(handle);
  std::ofstream stream(m_path, std::ios::binary);
  stream << text;
  stream.close();
  if (stream) return;
  m_remover.remove();
  fail("TemporaryFile", m_path + " cannot be written: is the disk full?");
}

TemporaryFile::~TemporaryFile() { m_remover.remove(); }

TemporaryFolder::TemporaryFolder() : m_path(pattern("")) {
  if (!mkdtemp(m_path.data())) fail("TemporaryFolder", "no temporary folder can be made as " + m_path);
  m_remover.watch(m_path);
}

TemporaryFolder::~TemporaryFolder() { m_remover.remove(); }

std::string file_content(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

} // namespace burnish

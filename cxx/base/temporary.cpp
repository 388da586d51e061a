#include "base/temporary.hpp"
#include "base/error.hpp"
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <stdlib.h>
#include <sys/socket.h>
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

// Its path, "" if it cannot be made.
std::string made(std::string path, int extension) {
  if (extension == Remover::FOLDER) return mkdtemp(path.data()) ? path : "";
  const int handle = mkstemps(path.data(), extension);
  if (handle >= 0) close(handle);
  return handle >= 0 ? path : "";
}

// That of a file that the other process has made, "" if it ends before.
std::string path_from(int connection, std::size_t size) {
  std::string path(size, 0);
  std::size_t have = 0;
  for (ssize_t got = 1; have < size && got != 0;) {
    got = read(connection, path.data() + have, size - have);
    if (got < 0 && errno != EINTR) break;
    if (got > 0) have += static_cast<std::size_t>(got);
  }
  return have == size ? path : "";
}

// The copy of this process shares all its files; it closes what it has no part in.
[[noreturn]] void make_and_remove(int connection, const std::string& pattern, int extension) {
  setsid();
  dup2(connection, 0);
  close_range(1, ~0U, 0);
  const std::string path = made(pattern, extension);
  if (path.empty()) _exit(1);
  char byte = 0;
  if (write(0, path.data(), path.size()) > 0) // else this process has ended
    while (read(0, &byte, 1) < 0 && errno == EINTR) {
    }
  std::error_code code;
  std::filesystem::remove_all(path, code);
  _exit(0);
}

} // namespace

std::string Remover::make(const std::string& pattern, int extension) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return m_path = made(pattern, extension);
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, &before); // Ctrl-C reaches both processes
  m_process = fork();
  if (m_process == 0) make_and_remove(ends[1], pattern, extension);
  sigprocmask(SIG_SETMASK, &before, nullptr);
  close(ends[1]);
  m_end = ends[0];
  return m_path = m_process > 0 ? path_from(m_end, pattern.size()) : made(pattern, extension);
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
    : m_path(m_remover.make(pattern(extension), static_cast<int>(extension.size()))) {
  if (m_path.empty()) fail("TemporaryFile", "no temporary file can be made as " + pattern(extension));
  std::ofstream stream(m_path, std::ios::binary);
  stream << text;
  stream.close();
  if (stream) return;
  m_remover.remove();
  fail("TemporaryFile", m_path + " cannot be written: is the disk full?");
}

TemporaryFile::~TemporaryFile() { m_remover.remove(); }

TemporaryFolder::TemporaryFolder() : m_path(m_remover.make(pattern(""), Remover::FOLDER)) {
  if (m_path.empty()) fail("TemporaryFolder", "no temporary folder can be made as " + pattern(""));
}

TemporaryFolder::~TemporaryFolder() { m_remover.remove(); }

std::string file_content(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

} // namespace burnish

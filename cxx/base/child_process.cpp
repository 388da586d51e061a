#include "base/child_process.hpp"
#include "base/error.hpp"
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace burnish {

namespace {

constexpr const char* RUN_IN_CHILD = "run_in_child";
constexpr int EXITED = 77;          // status of a child in which exit() was called
constexpr char BEFORE_RESULT = '.'; // before a result

void write_all(int handle, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = write(handle, text.data() + done, text.size() - done);
    if (n < 0 && errno != EINTR) return;
    if (n > 0) done += static_cast<std::size_t>(n);
  }
}

std::string read_all(int handle) {
  std::string text;
  char part[4096];
  for (;;) {
    const ssize_t n = read(handle, part, sizeof part);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(part, static_cast<std::size_t>(n));
  }
}

// A file that is read here may name a program; it is not started.
void forbid_programs() {
  sock_filter filter[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                          BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_execve, 1, 0),
                          BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_execveat, 0, 1),
                          BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
                          BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
  const sock_fprog program{sizeof filter / sizeof filter[0], filter};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0) prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

[[noreturn]] void be_child(const std::function<std::string()>& function, int log, int result) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  forbid_programs();
  std::atexit([] { _exit(EXITED); }); // before what the program itself does at its end
  try {
    write_all(result, BEFORE_RESULT + function());
  } catch (...) {
    std::abort();
  }
  std::cout.flush();
  std::fflush(nullptr);
  _exit(0);
}

} // namespace

ChildEnd run_in_child(const std::function<std::string()>& function, const std::string& log) {
  const int written = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (written < 0) fail(RUN_IN_CHILD, "\"" + log + "\" cannot be written: " + std::strerror(errno));
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    close(written);
    fail(RUN_IN_CHILD, std::string("no pipe: ") + std::strerror(errno));
  }
  // what waits in buffers would be written twice
  std::cout.flush();
  std::fflush(nullptr);
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, &before); // until the child has the default actions
  const pid_t child = fork();
  const int error = errno;
  if (child == 0) be_child(function, written, ends[1]);
  sigprocmask(SIG_SETMASK, &before, nullptr);
  close(written);
  close(ends[1]);
  const std::string said = child > 0 ? read_all(ends[0]) : "";
  close(ends[0]);
  if (child < 0) fail(RUN_IN_CHILD, std::string("no process can be made: ") + std::strerror(error));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  ChildEnd end;
  end.returned = !said.empty() && said[0] == BEFORE_RESULT;
  if (end.returned) end.result = said.substr(1);
  end.signal = !end.returned && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  end.exit = !end.returned && WIFEXITED(status) && WEXITSTATUS(status) == EXITED;
  return end;
}

} // namespace burnish

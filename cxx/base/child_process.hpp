#pragma once
// Code that may crash, hang or end the program, run in a copy of this process.
#include <functional>
#include <string>

namespace burnish {

/// How a child process ended.
struct ChildEnd {
  bool returned = false; ///< the function came to its end and gave a result
  std::string result;
  int signal = 0;    ///< that ended it, or 0
  bool exit = false; ///< something in it called exit()
};

/// Runs `function` in a fork of this process and waits for its end. Memory, streams, locale, signal handlers and
/// limits that it changes are those of the copy. There, standard input is empty, the standard output and error
/// go to the file `log`, no program can be started (system, exec), signals have their default actions (Ctrl-C reaches both processes), and exit() leaves
/// at once. An exception ends the copy with SIGABRT.
/// @throws std::invalid_argument if the log cannot be written, or no process can be made
ChildEnd run_in_child(const std::function<std::string()>& function, const std::string& log);

} // namespace burnish

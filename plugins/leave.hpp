#pragma once
// The end of a script with a status of our own.

namespace burnish {

/// Ends the script with this exit status: its variables and files are closed, nothing more is printed.
[[noreturn]] void leave(int status);
/// If the script ends by itself with status 0, the exit status is this one; 0: nothing is owed.
void owe(int status);
/// Of the process, once: it pays what is owed, with the other ranks.
void register_end();

} // namespace burnish

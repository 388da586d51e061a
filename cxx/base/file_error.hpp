#pragma once
// A file that could not be written: not bad input, so it is told apart.
#include <stdexcept>

namespace burnish {

/// Text: file, reason, and what is left of it.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

} // namespace burnish

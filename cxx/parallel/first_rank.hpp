#pragma once
// What is done once, by rank 0: files.
#include "base/error.hpp"
#include "base/file_error.hpp"
#include "parallel/ranks.hpp"

namespace burnish {

/// Rank 0's text becomes that of all.
void share_text(std::string& text);

/// How a piece of work of rank 0 ended, as the others are told.
struct WorkEnd {
  enum Kind : char { DONE, ARGUMENT_ERROR, FILE_ERROR, OTHER_ERROR } kind = DONE;
  std::string where, what; ///< ArgumentError: function, "" of one that has none; what is wrong
};
/// Rank 0's end becomes that of all; throws what it says.
void share_end(WorkEnd end);
/// In a catch block: what has been caught.
WorkEnd caught_end();

/// Runs f on rank 0 alone, all wait for it. What it throws is thrown by all, with the same text: as FileError, ArgumentError, or
/// std::runtime_error.
template <class F> void on_first_rank(F&& f) {
  if (ranks().size() == 1) return f();
  WorkEnd end;
  try {
    if (ranks().rank() == 0) f();
  } catch (...) {
    end = caught_end();
  }
  share_end(std::move(end));
}

} // namespace burnish

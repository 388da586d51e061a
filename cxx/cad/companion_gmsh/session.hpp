#pragma once
// gmsh from its start to what it said last.
#include <new>
#include <string>

namespace burnish_gmsh {

/// Begins a model. @param prints on the standard output what gmsh does
void start(bool prints);
/// The first error that gmsh tells, "" if none.
std::string first_error();
/// The last lines of what it says, errors and warnings if there are any.
std::string last_lines();
/// A text that is handed out, null for "".
const char* told(const std::string& text);

/// What a call returns, or throws, as a text that is handed out.
template <class Call> const char* without_exceptions(const Call& call) {
  try {
    return told(call());
  } catch (const std::bad_alloc&) {
    return told("it takes more memory than it may");
  } catch (...) {
    const std::string said = first_error();
    return told(said.empty() ? "gmsh gives up without a reason" : said);
  }
}

} // namespace burnish_gmsh

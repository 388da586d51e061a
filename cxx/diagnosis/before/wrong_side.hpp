#pragma once
// Words of errors about a tool that faces away from the body.
#include <string>

namespace burnish {

/// What to do with a tool that is met from inside the workpiece.
template <int Dim> std::string turned_to_the_body() {
  return Dim == 2 ? "if its profile has the body on the wrong side, turn it: inside=true, or the points in "
                    "the other order"
                  : "if its surface has the body on the wrong side, turn it: inside=true, the normal of "
                    "plane= the other way, or "
                    "the points of its profile in the other order";
}

/// Where the body is, seen from a tool.
template <int Dim> std::string side_of_the_body() {
  return Dim == 2 ? "the body lies on the left of an open profile: reverse one that faces away"
                  : "the normal of its surface points to the body: turn one that faces away";
}

} // namespace burnish

#pragma once
// Plain data of a run in the plane or in space as bytes and back.
#include "base/archive.hpp"
#include "base/error.hpp"
#include <sstream>

namespace burnish {

/// Dimension and value.
template <int Dim, class Value> std::string bytes_of(const Value& value) {
  std::ostringstream bytes(std::ios::binary);
  {
    Writer archive(bytes);
    archive(Dim, value);
  }
  return bytes.str();
}

/// @param where function that is named in errors; @param what "state", "mesh"
/// @throws std::invalid_argument if the bytes are not those of a value of this dimension
template <int Dim, class Value>
Value value_of_bytes(const std::string& bytes, const char* where, const std::string& what) {
  std::istringstream stream(bytes, std::ios::binary);
  Value value;
  try {
    Reader archive(stream);
    int dimension = 0;
    archive(dimension);
    require(dimension == Dim, where, ("dimension of the " + what).c_str(), dimension,
            std::to_string(Dim).c_str());
    archive(value);
  } catch (const cereal::Exception& error) {
    fail(where, "no " + what + " of a run: " + error.what());
  }
  return value;
}

} // namespace burnish

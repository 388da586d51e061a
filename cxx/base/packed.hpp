#pragma once
// Plain data of a run in the plane or in space as bytes and back.
#include "base/archive.hpp"
#include "base/error.hpp"
#include <sstream>

namespace burnish {

/// What is written is counted and goes to the end of a string, if there is one: written twice, it takes no more memory than its size.
class EndOfString : public std::streambuf {
public:
  explicit EndOfString(std::string* bytes) : m_bytes(bytes) {}
  std::size_t count() const { return m_count; }

private:
  std::streamsize xsputn(const char* from, std::streamsize size) override {
    if (m_bytes) m_bytes->append(from, static_cast<std::size_t>(size));
    m_count += static_cast<std::size_t>(size);
    return size;
  }
  std::string* m_bytes;
  std::size_t m_count = 0;
};

/// Dimension and value.
template <int Dim, class Value> std::string bytes_of(const Value& value) {
  const auto put = [&](EndOfString& end) {
    std::ostream stream(&end);
    Writer archive(stream);
    archive(Dim, value);
  };
  EndOfString counted(nullptr);
  put(counted);
  std::string bytes;
  bytes.reserve(counted.count());
  EndOfString end(&bytes);
  put(end);
  return bytes;
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

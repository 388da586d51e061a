#pragma once
// Reads arrays back from a file of VtkFile.
#include "base/temporary.hpp"
#include <cstdint>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace burnish::test {

/// Bytes of a text in base64 [RFC 4648].
inline std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) break;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<char>(group >> bits & 0xff));
  }
  return bytes;
}

class VtkReader {
public:
  /// @param save writes the file
  explicit VtkReader(const std::function<void(const std::string& path)>& save) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/file";
    save(path);
    m_text = file_content(path);
  }
  const std::string& text() const { return m_text; }
  /// Numbers of the array of that name. @tparam Number that of the file. @throws std::out_of_range if there is none
  template <class Number> std::vector<Number> array(const std::string& name) const {
    const std::size_t tag = m_text.find("Name=\"" + name + "\"");
    if (tag == std::string::npos) throw std::out_of_range(name);
    const std::size_t begin = m_text.find('>', tag) + 1;
    const std::string bytes = from_base64(m_text.substr(begin, m_text.find('<', begin) - begin));
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data(), sizeof size);
    std::vector<Number> values(size / sizeof(Number));
    std::memcpy(values.data(), bytes.data() + sizeof size, size);
    return values;
  }

private:
  std::string m_text;
};

} // namespace burnish::test

#include "output/vtk_file.hpp"
#include <cstring>

namespace burnish {
namespace {

constexpr char DIGITS[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

bool little_endian() {
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

} // namespace

void append_base64(const void* data, std::size_t bytes, std::string& text) {
  const auto* byte = static_cast<const unsigned char*>(data);
  std::size_t at = text.size();
  text.resize(at + (bytes + 2) / 3 * 4, '=');
  for (std::size_t i = 0; i < bytes; i += 3, at += 4) {
    const std::size_t left = bytes - i;
    const unsigned group = byte[i] << 16 | (left > 1 ? byte[i + 1] << 8 : 0) | (left > 2 ? byte[i + 2] : 0);
    text[at] = DIGITS[group >> 18];
    text[at + 1] = DIGITS[group >> 12 & 63];
    if (left > 1) text[at + 2] = DIGITS[group >> 6 & 63];
    if (left > 2) text[at + 3] = DIGITS[group & 63];
  }
}

VtkFile::VtkFile(std::string type) {
  m_text = "<?xml version=\"1.0\"?>\n";
  open("VTKFile", "type=\"" + type + "\" version=\"1.0\" header_type=\"UInt64\" byte_order=\"" +
                      (little_endian() ? "LittleEndian\"" : "BigEndian\""));
  open(type);
}

void VtkFile::open(const std::string& tag, const std::string& attributes) {
  m_text += "<" + tag + (attributes.empty() ? "" : " ") + attributes + ">\n";
  m_open.push_back(tag);
}

void VtkFile::close() {
  m_text += "</" + m_open.back() + ">\n";
  m_open.pop_back();
}

void VtkFile::write(const char* type, const std::string& name, const std::string& attributes,
                    const void* data, std::size_t bytes) {
  m_text += std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\"" + attributes +
            " format=\"binary\">";
  std::string block(sizeof(std::uint64_t) + bytes, '\0');
  const std::uint64_t size = bytes;
  std::memcpy(block.data(), &size, sizeof size);
  if (bytes > 0) std::memcpy(block.data() + sizeof size, data, bytes);
  append_base64(block.data(), block.size(), m_text);
  m_text += "</DataArray>\n";
}

void VtkFile::array(const std::string& name, int components, const std::vector<double>& values,
                    const std::vector<std::string>& names) {
  std::string attributes;
  if (components > 1) attributes = " NumberOfComponents=\"" + std::to_string(components) + "\"";
  for (std::size_t i = 0; i < names.size(); ++i)
    attributes += " ComponentName" + std::to_string(i) + "=\"" + names[i] + "\"";
  write("Float64", name, attributes, values.data(), values.size() * sizeof(double));
}
void VtkFile::array(const std::string& name, const std::vector<std::int64_t>& values) {
  write("Int64", name, "", values.data(), values.size() * sizeof(std::int64_t));
}
void VtkFile::array(const std::string& name, const std::vector<std::uint8_t>& values) {
  write("UInt8", name, "", values.data(), values.size());
}

void VtkFile::field(const std::string& name, double value) {
  write("Float64", name, " NumberOfTuples=\"1\"", &value, sizeof value);
}

void VtkFile::lines(const std::vector<std::vector<int>>& lines, const char* tag) {
  std::vector<std::int64_t> connectivity, offsets;
  for (const auto& line : lines) {
    connectivity.insert(connectivity.end(), line.begin(), line.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  open(tag);
  array("connectivity", connectivity);
  array("offsets", offsets);
  close();
}

std::string VtkFile::text() {
  while (!m_open.empty()) close();
  return m_text;
}

} // namespace burnish

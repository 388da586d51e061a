#pragma once
// A file of VTK's XML formats, as ParaView reads it: numbers in double precision, as base64 within the text.
#include <cstdint>
#include <string>
#include <vector>

namespace burnish {

class VtkFile {
public:
  /// @param type  "UnstructuredGrid" (.vtu) or "PolyData" (.vtp)
  explicit VtkFile(std::string type);
  /// Begins and ends an element, `Piece` with its attributes for one: open("Piece", "NumberOfPoints=\"3\"").
  void open(const std::string& tag, const std::string& attributes = "");
  void close();
  /// Point-major numbers. @param names  of the components, as ParaView lists them; empty: none
  void array(const std::string& name, int components, const std::vector<double>& values,
             const std::vector<std::string>& names = {});
  void array(const std::string& name, const std::vector<std::int64_t>& values);
  void array(const std::string& name, const std::vector<std::uint8_t>& values);
  /// A number of the field data, which belongs to no point and no cell.
  void field(const std::string& name, double value);
  /// Lines through points as the cells of a .vtp file; tag "Verts": points alone, "Polys": polygons.
  void lines(const std::vector<std::vector<int>>& lines, const char* tag = "Lines");
  /// The whole file; closes what is open.
  std::string text();

private:
  void write(const char* type, const std::string& name, const std::string& attributes, const void* data,
             std::size_t bytes);
  std::vector<std::string> m_open; // tags
  std::string m_text;
};

/// Bytes in base64 [RFC 4648], appended to the text.
void append_base64(const void* data, std::size_t bytes, std::string& text);

} // namespace burnish

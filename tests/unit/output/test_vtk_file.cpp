#include "output/file_units.hpp"
#include "output/vtk_file.hpp"
#include <array>
#include <gtest/gtest.h>

using namespace burnish;

namespace {

std::string base64(const std::string& bytes) {
  std::string text = ">";
  append_base64(bytes.data(), bytes.size(), text);
  return text;
}

} // namespace

// [RFC 4648] section 10.
TEST(VtkFile, Base64) {
  EXPECT_EQ(base64(""), ">");
  EXPECT_EQ(base64("f"), ">Zg==");
  EXPECT_EQ(base64("fo"), ">Zm8=");
  EXPECT_EQ(base64("foo"), ">Zm9v");
  EXPECT_EQ(base64("foob"), ">Zm9vYg==");
  EXPECT_EQ(base64("fooba"), ">Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), ">Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), ">//79");
}

TEST(VtkFile, NumberOfTheFieldData) {
  VtkFile file("UnstructuredGrid");
  file.open("FieldData");
  file.field("meters_per_length", 1.);
  EXPECT_NE(file.text().find(
                "<FieldData>\n<DataArray type=\"Float64\" Name=\"meters_per_length\" NumberOfTuples=\"1\" "
                "format=\"binary\">CAAAAAAAAAAAAAAAAADwPw==</DataArray>\n</FieldData>"),
            std::string::npos)
      << file.text();
}

TEST(FileUnits, KnownOnes) {
  const FileUnits units = file_units("mm", "MPa");
  EXPECT_EQ(units.length + units.stress, "mmMPa");
  EXPECT_EQ(units.meters, 1e-3);
  EXPECT_EQ(units.pascals, 1e6);
  for (const auto& [length, stress, what] : std::vector<std::array<std::string, 3>>{
           {"inch", "MPa", "unit of length \"inch\", expected one of m, cm, mm, um"},
           {"mm", "N/mm2", "unit of stress \"N/mm2\", expected one of Pa, kPa, MPa, GPa"}})
    try {
      file_units(length, stress);
      FAIL() << length << " " << stress;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "rcUnits: " + what);
    }
}

// Whatever is open is closed, the innermost first; each array goes after its size in bytes.
TEST(VtkFile, ElementsAndArrays) {
  VtkFile file("PolyData");
  file.open("Piece", "NumberOfPoints=\"1\"");
  file.open("PointData");
  file.array("u", 2, {0., 0.}, {"X", "Y"});
  const std::string text = file.text();
  EXPECT_NE(text.find("<DataArray type=\"Float64\" Name=\"u\" NumberOfComponents=\"2\" ComponentName0=\"X\" "
                      "ComponentName1=\"Y\" format=\"binary\">EAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA</DataArray>"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("</PointData>\n</Piece>\n</PolyData>\n</VTKFile>\n"), std::string::npos);
}

TEST(VtkFile, LinesEndWhereTheNextBegins) {
  VtkFile file("PolyData"), same("PolyData");
  file.lines({{0, 1, 2}, {3, 4}});
  same.open("Lines");
  same.array("connectivity", std::vector<std::int64_t>{0, 1, 2, 3, 4});
  same.array("offsets", std::vector<std::int64_t>{3, 5});
  EXPECT_EQ(file.text(), same.text());
}

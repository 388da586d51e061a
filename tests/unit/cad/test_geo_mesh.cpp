#include "base/temporary.hpp"
#include "cad/geo_mesh.hpp"
#include "cad/size_fields.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>
#include <filesystem>
#include <map>

using namespace burnish;
using namespace burnish::test;

namespace {

/// A unit square by two lines of text, physical groups among them; `more` follows.
std::string square(const std::string& more) {
  return "DefineConstant[ H = 1 ];\nPoint(1) = {0, 0, 0, 0.3}; Point(2) = {1, 0, 0, 0.3}; Point(3) = {1, H, "
         "0, 0.3};"
         "Point(4) = {0, H, 0, 0.3}; Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};"
         "Curve Loop(1) = {1:4}; Plane Surface(1) = {1};\n" +
         more + "\n";
}
const char* const GROUPS = "Physical Curve(3) = {1, 2}; Physical Surface(1) = {1};";

void refuses(const std::string& text, const std::string& numbers, const std::string& message) {
  const TemporaryFile file(text, ".geo");
  const TemporaryFolder folder;
  expect_invalid([&] { mesh_geo(file.path(), numbers, folder.path() + "/mesh"); }, message);
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/mesh.msh"));
}

} // namespace

TEST(GeoMesh, WritesTheMeshAndALog) {
  const TemporaryFolder folder;
  const std::string result = folder.path() + "/new/folder/mesh";
  // what the file itself says of formats is overruled
  const TemporaryFile file(square(std::string(GROUPS) + "Mesh.MshFileVersion = 4.1; Mesh.Binary = 1;"),
                           ".geo");
  testing::internal::CaptureStdout();
  mesh_geo(file.path(), "H=2", result);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  const std::string text = file_content(result + ".msh");
  EXPECT_EQ(text.rfind("$MeshFormat\n2.2 0 8\n", 0), 0u) << text.substr(0, 40);
  EXPECT_NE(text.find(" 1 2 0\n"), std::string::npos) << "a point at the height given";
  EXPECT_NE(file_content(result + ".log").find("Meshing 2D"), std::string::npos);
}

TEST(GeoMeshErrors, FilesAndNumbers) {
  expect_invalid([] { mesh_geo("nowhere.geo", "", "x"); },
                 "\"nowhere.geo\" does not exist, seen from folder");
  expect_invalid([] { mesh_geo("README.md", "", "x"); }, "\"README.md\" ends in \".md\", expected .geo");
  const TemporaryFile file(square(GROUPS), ".geo");
  expect_invalid([&] { mesh_geo(file.path(), "H=", "x"); }, "mesh_geo: \"H=\" is no number for the geometry");
  expect_invalid([&] { mesh_geo(file.path(), "Q=1", "x"); }, "has no number \"Q\"");
  expect_invalid([&] { mesh_geo(file.path(), "", "README.md/x"); }, "folder \"README.md\" cannot be made");
  EXPECT_FALSE(std::filesystem::exists("x.msh"));
}

TEST(GeoMeshErrors, WhatGmshSays) {
  refuses(square("Line(9) = {1, 77};"), "",
          "\", its last lines:\n  Error: Unknown control point 77 in GEO curve 9");
  refuses(square(std::string("H = 3;") + GROUPS), "H=2",
          "it gives H another value, 3; write DefineConstant[ H = ... ] there");
  refuses(square("If (1) Exit; EndIf"), "", "it ends gmsh itself: take Exit out of it");
  refuses(square("SystemCall \"ls\";"), "", "line 3: SystemCall would run another program; take it out");
  refuses("SetFactory(\"OpenCASCADE\"); Point(1) = {Sqrt(-1), 0, 0}; Point(2) = {Sqrt(-1), 1, 0}; Line(1) = "
          "{1, 2};\n",
          "", "gmsh failed on");
}

TEST(GeoMeshErrors, WhatTheMeshLacks) {
  refuses(square("Physical Curve(3) = {1, 2};"), "", "no triangles in the mesh of \"");
  refuses(square("Physical Surface(1) = {1};"), "", "has no physical curves; they become the labels");
  refuses(square(""), "", "has no physical curves");
}

namespace {

const char* const BOX = "SetFactory(\"OpenCASCADE\"); Box(1) = {0, 0, 0, 1, 1, 1}; Mesh.MeshSizeMax = 0.5;\n";

/// Largest and smallest edge of the tetrahedra of a .msh file that have a vertex within a ball, and their number.
struct Edges {
  double longest = 0, shortest = 1e300;
  int tetrahedra = 0;
};
Edges edges_near(const std::string& path, const std::array<double, 3>& center, double radius) {
  std::istringstream text(file_content(path));
  std::string word;
  std::map<long, std::array<double, 3>> node;
  Edges edges;
  while (text >> word) {
    long count = 0;
    if (word == "$Nodes") {
      text >> count;
      for (long k = 0, number = 0; k < count; ++k) {
        text >> number;
        auto& x = node[number];
        text >> x[0] >> x[1] >> x[2];
      }
    }
    if (word != "$Elements") continue;
    text >> count;
    for (long k = 0; k < count; ++k) {
      long number = 0, type = 0, tags = 0, tag = 0;
      text >> number >> type >> tags;
      for (long t = 0; t < tags; ++t) text >> tag;
      std::vector<long> corner(type == 4 ? 4 : type == 2 ? 3 : type == 1 ? 2 : 1);
      for (long& c : corner) text >> c;
      if (type != 4) continue;
      const auto distance = [&](const auto& a, const auto& b) {
        return std::sqrt(std::pow(a[0] - b[0], 2) + std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2));
      };
      if (distance(node[corner[0]], center) > radius) continue;
      ++edges.tetrahedra;
      for (int a = 0; a < 3; ++a)
        for (int b = a + 1; b < 4; ++b) {
          const double length = distance(node[corner[a]], node[corner[b]]);
          edges.longest = std::max(edges.longest, length);
          edges.shortest = std::min(edges.shortest, length);
        }
    }
  }
  return edges;
}

} // namespace

TEST(GeoMesh, VolumesAndSizeFields) {
  const TemporaryFile file(BOX + std::string("Physical Surface(3) = {6}; Physical Volume(1) = {1};\n"),
                           ".geo");
  const TemporaryFolder folder;
  mesh_geo(file.path(), "", folder.path() + "/even", {3, ""});
  EXPECT_GT(edges_near(folder.path() + "/even.msh", {0.5, 0.5, 0.5}, 10).tetrahedra, 20);
  const std::string sizes = size_fields({{{0, 0, 1}, 0.2, 0.05}}, 0.5, 0.3, "test");
  mesh_geo(file.path(), "", folder.path() + "/graded", {3, sizes});
  const Edges near = edges_near(folder.path() + "/graded.msh", {0, 0, 1}, 0.15);
  EXPECT_GT(near.tetrahedra, 50);
  EXPECT_LE(near.longest, 2 * 0.05);
  EXPECT_GE(near.shortest, 0.4 * 0.05);
  EXPECT_GE(edges_near(folder.path() + "/graded.msh", {1, 1, 0}, 0.3).longest, 0.2);
}

TEST(GeoMeshErrors, VolumesAndSizeFields) {
  const auto refuses_volume = [](const std::string& more, const std::string& message) {
    const TemporaryFile file(BOX + more + "\n", ".geo");
    const TemporaryFolder folder;
    expect_invalid([&] { mesh_geo(file.path(), "", folder.path() + "/mesh", {3, ""}); }, message);
    EXPECT_FALSE(std::filesystem::exists(folder.path() + "/mesh.msh"));
  };
  refuses_volume("Physical Surface(3) = {6};",
                 "; with physical surfaces the volume needs Physical Volume(1) = {1};");
  refuses_volume("Physical Volume(3) = {1};",
                 "has no physical surfaces; they become the labels: Physical Surface(3) = {1, 2};");
  const auto fields = [](double radius, double length) {
    return size_fields({{{0, 0, 0}, radius, length}}, 1, 0.3, "rcGradedMesh3");
  };
  expect_invalid([&] { fields(0.2, 1); }, "rcGradedMesh3: h = 1, expected 0 < h < coarse");
  expect_invalid([&] { fields(0, 0.1); }, "size = 0, expected finite > 0");
  expect_invalid([&] { fields(1, 1e-3); }, "expected at most 5e6");
  expect_invalid([] { size_fields({}, 1, 0.3, "here"); }, "here: number of places = 0");
}

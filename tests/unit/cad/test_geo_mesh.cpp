#include "base/temporary.hpp"
#include "cad/geo_mesh.hpp"
#include "unit/finite_difference.hpp"
#include <filesystem>

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

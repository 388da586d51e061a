// Damaged CAD files are errors that tell what is wrong; none may end the program, hang it or be read as something else.
#include "unit/cad/cad_samples.hpp"
#include "unit/finite_difference.hpp"
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepTools.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS_Edge.hxx>
#include <chrono>
#include <gp_Ax2d.hxx>
#include <random>

using namespace burnish;
using namespace burnish::test;

namespace {

std::string content(const std::string& name) {
  const std::string text = file_content("tests/support/cad/" + name);
  EXPECT_FALSE(text.empty()) << name;
  return text;
}

std::string with(std::string text, const std::string& old, const std::string& other) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), other);
}

CadCurve opened(const std::string& text, const std::string& extension) {
  const TemporaryFile file(text, extension);
  CadSelection selection;
  selection.file = file.path();
  return CadCurve(selection);
}

void refuses(const std::string& text, const std::string& extension, const std::string& message) {
  SCOPED_TRACE(message);
  expect_invalid([&] { opened(text, extension); }, message);
}

std::string random_bytes(unsigned seed) {
  std::mt19937 random(seed);
  std::string text;
  for (int i = 0; i < 5000; ++i) text += static_cast<char>(1 + random() % 255);
  return text;
}

} // namespace

TEST(CadDamaged, NumbersInStepFiles) {
  const std::string step = content("lobe.step"), point = "CARTESIAN_POINT('',(";
  const std::size_t digits = step.find("CARTESIAN_POINT('',(1") + point.size();
  const std::string number = step.substr(digits, step.find(',', digits) - digits);
  for (const char* wrong : {"NaN", "nan", "inf", "1E300"}) // NaN was read as 0; 1E300 lacks the point
    refuses(with(step, point + number, point + wrong), ".step", "Incorrect syntax: ");
  for (const char* wrong : {"$", "#1", "'12'"})
    refuses(with(step, point + number, point + wrong), ".step",
            "entity #40: Parameter n0.1 (coordinates) not a Real");
  for (const char* huge : {"1.E300", "1.E400", "-1.E200"})
    refuses(with(step, point + number, point + huge), ".step", "CadCurve: curve 1 ");
}

TEST(CadDamaged, ReferencesInStepFiles) {
  const std::string step = content("circle.step");
  refuses(with(step, "(#16)", "(#999)"), ".step", "Unresolved Reference");
  refuses(with(step, "SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT(.MILLI.,.CUBIT.)"), ".step", "CadFile: ");
  refuses(with(step, "CIRCLE('", "CIRKLE('"), ".step", "CadFile: ");
}

TEST(CadDamaged, NumbersInBrepFiles) {
  const std::string brep = content("circle.brep");
  for (const char* wrong : {"nan", "1e300", "inf"}) {
    SCOPED_TRACE(wrong);
    EXPECT_THROW(opened(with(brep, " 15\n", std::string(" ") + wrong + "\n"), ".brep"),
                 std::invalid_argument);
  }
  refuses(with(brep, " 15\n", " -NaN(2)\n"), ".brep", "line 7: -NaN(2) is no finite number");
  // the reader never comes back from a curve on a surface that ends at NaN, nor the knots of a closed spline
  refuses(with(brep, "Curve2ds 0\n", "Curve2ds 1\n8 nan 6.28\n2 0 0 1 0 -0 1 1\n"), ".brep",
          "line 6: nan is no finite number");
  const std::string lobe = content("lobe.brep");
  for (const char* knot : {" 1e400 2", " 1e60 2"})
    refuses(with(lobe, " 8 2", knot), ".brep", " knots that are not finite or do not ascend");
  refuses(with(brep, " 15\n", " -15\n"), ".brep", "has no curve in space");
  refuses(with(brep, "Curves 1", "Curves 123456789"), ".brep", "the text is damaged or cut short");
}

// Cut at 95 % the reader of OpenCASCADE waits for ever.
TEST(CadDamaged, FilesCutShort) {
  const auto start = std::chrono::steady_clock::now();
  for (const char* name : {"circle.brep", "lobe.step", "punch.step"})
    for (double part = 0.1; part < 0.98; part += 0.05) {
      SCOPED_TRACE(name + std::to_string(part));
      const std::string text = content(name);
      EXPECT_THROW(opened(text.substr(0, static_cast<std::size_t>(part * static_cast<double>(text.size()))),
                          std::string(name).substr(std::string(name).find('.'))),
                   std::invalid_argument);
    }
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 60);
}

TEST(CadDamaged, NothingAndNonsense) {
  for (const char* extension : {".step", ".stp", ".brep", ".geo"}) {
    refuses("", extension, "is empty");
    refuses(" \n\n", extension, "is empty");
    SCOPED_TRACE(extension);
    EXPECT_THROW(opened(random_bytes(1), extension), std::invalid_argument);
  }
  EXPECT_THROW(opened("ISO-10303-21;\n" + random_bytes(2), ".step"), std::invalid_argument);
  EXPECT_THROW(opened("\nCASCADE Topology V1, (c) Matra-Datavision\n" + random_bytes(3), ".brep"),
               std::invalid_argument);
}

TEST(CadDamaged, GeoFiles) {
  // gmsh ends the process over a point of OpenCASCADE that is not finite, and never leaves a Macro that calls itself
  const std::string nan = std::string(OPENCASCADE) +
                          "For i In {1:9}\n Point(i) = {Sqrt(-i), i, 0};\nEndFor\nSpline(1) = {1:9};\n";
  EXPECT_THROW(opened(nan, ".geo"), std::invalid_argument);
  EXPECT_THROW(opened("Point(1) = {0, 0, 0}; Point(2) = {1e300, 0, 0}; Line(1) = {1, 2};\n", ".geo"),
               std::invalid_argument);
  const TemporaryFile again("Macro A\nCall A;\nReturn\nCall A;\nPoint(1) = {0, 0, 0};\n", ".geo");
  CadSelection selection;
  selection.file = again.path();
  selection.seconds = 0.5;
  expect_invalid([&] { CadCurve curve(selection); }, "gmsh ");
  const TemporaryFile asleep("Sleep 1000;\n", ".geo");
  selection.file = asleep.path();
  selection.seconds = 0.05;
  expect_invalid([&] { CadCurve curve(selection); },
                 "gmsh takes too long over it: does it call itself, or repeat something without end?");
}

TEST(CadDamaged, TheNextFileIsReadAsEver) {
  EXPECT_THROW(opened(content("lobe.step").substr(0, 3000), ".step"), std::invalid_argument);
  EXPECT_NEAR(stored("circle.step").tightest_radius(), 15, 1e-12);
  EXPECT_NEAR(stored("circle.geo").tightest_radius(), 15, 1e-12);
}

// Not damaged, but rare: an edge that has only a curve on its surface.
TEST(CadDamaged, CurvesOnSurfacesOnly) {
  const Handle(Geom_Surface) plane = new Geom_Plane(gp_Pnt(2, 3, 0), gp_Dir(0, 0, 1));
  const Handle(Geom2d_Curve) circle = new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(0, 0), gp_Dir2d(1, 0)), 5);
  const TemporaryFile file("", ".brep");
  BRepTools::Write(BRepBuilderAPI_MakeEdge(circle, plane).Edge(), file.path().c_str());
  CadSelection selection;
  selection.file = file.path();
  const CadCurve curve(selection);
  EXPECT_NEAR(curve.tightest_radius(), 5, 1e-14);
  EXPECT_NEAR(curve.closest_point({2, 13}, Param<2>(0.)).gap, 5, 1e-13);
}

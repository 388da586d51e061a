// CAD files that an unfriendly user gives: what is refused, with place and numbers, and what only looks
// wrong.
#include "unit/cad/cad_samples.hpp"
#include "unit/finite_difference.hpp"
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>

using namespace burnish;
using namespace burnish::test;

namespace {

void refuses_file(const std::string& extension, const std::string& text, const std::string& message) {
  const TemporaryFile file(text, extension);
  CadSelection selection;
  selection.file = file.path();
  expect_invalid([&] { CadCurve curve(selection); }, message);
}

void refuses(const std::string& geo, const std::string& message) {
  expect_invalid([&] { drawn(geo); }, message);
}

std::string half_of(const std::string& name) {
  std::ifstream stream("tests/support/cad/" + name);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str().substr(0, text.str().size() / 2);
}

const char* const TWO = "Point(1) = {1, 1, 0}; Point(2) = {3, 1, 0}; Point(3) = {1, 1, 0};\n";

} // namespace

TEST(CadErrors, KindOfFile) {
  refuses_file(".step", std::string(4000, '\0'), "is no text: it has bytes of value 0");
  refuses_file(".geo", "Point(1)" + std::string(3, '\0'), "is no text");
  refuses_file(".step", half_of("circle.brep"), "is no STEP file: it does not begin with \"ISO-10303-21\"");
  refuses_file(".brep", half_of("circle.step"), "is no BREP file: it does not begin with");
  refuses_file(
      ".step", half_of("lobe.step"),
      "the text is damaged or cut short; OpenCASCADE says: **** ERR StepFile : Undefined Parsing: Line 70");
  refuses_file(".brep", half_of("circle.brep"), "the text is damaged or cut short");
  refuses_file(".geo", half_of("circle.step"), "line 1: Unknown command 'ISO'");
}

TEST(CadErrors, NoOrdinaryFile) { // reading it would wait forever
  const std::string pipe =
      std::filesystem::temp_directory_path() / ("burnish-" + std::to_string(getpid()) + ".geo");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  CadSelection selection;
  selection.file = pipe;
  expect_invalid([&] { CadCurve curve(selection); }, "is no ordinary file");
  std::filesystem::remove(pipe);
}

// gmsh's Exit ends the whole process, with status 0; a copy of this one.
TEST(CadErrors, ExitInAGeoFile) {
  const std::string line = std::string(TWO) + "Line(1) = {1, 2};";
  for (const char* end : {"\nExit;", "/* so */ Exit;", "If (1) Exit; EndIf"})
    refuses(line + end, "it ends gmsh itself: take Exit out of it");
  EXPECT_NEAR(drawn(line + "\n// Exit;\nPrintf(\"Exit\");\nExitLength = 3;").length(), 2, 1e-14);
}

TEST(CadErrors, IncludedFilesAreLookedThrough) {
  const std::string line = std::string(TWO) + "DefineConstant[ R = 2 ]; Line(1) = {1, 2};\n";
  const TemporaryFile harmless(line, ".geo"), ends(line + "Exit;\n", ".geo");
  const auto including = [](const TemporaryFile& file) {
    return "Include \"" + std::filesystem::path(file.path()).filename().string() + "\";\n";
  };
  refuses(including(ends), "it ends gmsh itself");
  EXPECT_NEAR(drawn(including(harmless), {}, "R=3").length(), 2, 1e-14);
  expect_invalid([&] { drawn(including(harmless), {}, "Q=3"); }, "has no number \"Q\"");
}

TEST(CadErrors, CurvesOfASolidHaveToBeNamed) {
  const std::string box = std::string(OPENCASCADE) + "Box(1) = {0, 0, 0, 1, 2, 3};";
  refuses(box, "curve 1 of ");
  refuses(box, "is not in the plane z = 0: it passes through (0, 0, 3); name the curves of the profile "
               "(curves = [...]) out of 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12");
  EXPECT_NEAR(drawn(box, {4}).length(), 2, 1e-12);
}

TEST(CadErrors, Cusp) {
  refuses("Point(1) = {-1, 1, 0}; Point(2) = {1, -1, 0}; Point(3) = {-1, -1, 0}; Point(4) = {1, 1, 0};"
          "Bezier(1) = {1, 2, 3, 4};",
          "curve 1 has no tangent at (0, -0.5)");
}

TEST(CadErrors, CurvesWithoutLength) {
  refuses(std::string(TWO) + "Line(1) = {1, 3};", "curve 1 (Line) of ");
  refuses(std::string(TWO) + "Line(1) = {1, 3};", "has no length: all its points are at (1, 1)");
  refuses(std::string(TWO) + "Spline(1) = {1, 3, 1};", "has no length: all its points are at (1, 1)");
  refuses("Point(1) = {0, 0, 0}; Point(2) = {1e-9, 0, 0}; Point(3) = {1, 0, 0}; Line(1) = {1, 2}; Line(2) = "
          "{2, 3};",
          "curve 1 at (0, 0) is too short: 1e-09 long, in a chain of size 1 at least 1e-06 is needed; take "
          "it out");
}

TEST(CadErrors, TooSmallForOpenCascade) {
  const std::string points =
      "Point(1) = {1e-12, 0, 0}; Point(2) = {3e-12, 1e-12, 0}; Point(3) = {5e-12, 0, 0};\n";
  refuses(OPENCASCADE + points + "Spline(1) = {1, 2, 3};",
          "points of a curve closer than 1e-7, which it takes for one?");
  EXPECT_NEAR(drawn(points + "Spline(1) = {1, 2, 3};").tightest_radius(), 1e-12, 1e-20);
}

TEST(CadErrors, PointsThatAreNotFinite) {
  refuses("Point(1) = {0, 0, 0}; Point(2) = {Sqrt(-1), 0, 0}; Line(1) = {1, 2};",
          "has points that are not finite");
  refuses("Point(1) = {0, 0, 0}; Point(2) = {1/0, 0, 0}; Line(1) = {1, 2};", "Division by zero");
}

TEST(CadErrors, CurvesDrawnTwice) {
  refuses(std::string(TWO) + "Line(1) = {1, 2}; Line(2) = {1, 2};",
          "curves 1 and 2 turn back on each other at (3, 1): a cusp, or a curve drawn twice");
  refuses(std::string(TWO) + "Point(4) = {2, 1, 0}; Line(1) = {1, 2}; Line(2) = {2, 4};",
          "turn back on each other");
}

// Two arcs that their chords cross: a crescent of thickness 0.002, radius 10.
TEST(CadErrors, ThinShapesDoNotCrossThemselves) {
  const std::string crescent =
      "t = 0.002; Point(1) = {10 + t/2, 0, 0}; Point(2) = {0, 10 + t/2, 0}; Point(3) = {0, 10 - t/2, 0};"
      "Point(4) = {10 - t/2, 0, 0}; Point(5) = {0, 0, 0}; Point(6) = {0, 10, 0}; Point(7) = {10, 0, 0};"
      "Point(8) = {-t/2, 10, 0}; Point(9) = {10, -t/2, 0};"
      "Circle(1) = {1, 5, 2}; Circle(2) = {2, 6, 8}; Circle(3) = {8, 6, 3}; Circle(4) = {3, 5, 4};"
      "Circle(5) = {4, 7, 9}; Circle(6) = {9, 7, 1};";
  const CadCurve curve = drawn(crescent);
  EXPECT_TRUE(curve.closed());
  EXPECT_NEAR(curve.tightest_radius(), 1e-3, 1e-8);
  EXPECT_NEAR(curve.closest_point({10 * std::sqrt(0.5), 10 * std::sqrt(0.5)}, Param<2>(0.)).gap, -1e-3,
              1e-12);
}

// OpenCASCADE evaluates it with 1e-12 of rounding: more than others.
TEST(CadErrors, BezierOfHighDegree) {
  const double y[] = {8.26, 1.74, 1.44, -10.96, -3.6, -6.27, -7.32, -4.41, -3.84, -11.96, 12.65};
  std::string points = OPENCASCADE;
  for (int i = 0; i < 11; ++i)
    points += "Point(" + std::to_string(i + 1) + ") = {" + std::to_string(2 * i) + ", " +
              std::to_string(y[i]) + ", 0};\n";
  const CadCurve curve = drawn(points + "Bezier(1) = {1:11};");
  EXPECT_FALSE(curve.closed());
  for (double part = 0.05; part < 1; part += 0.1) {
    const double s = part * curve.length(), h = 1e-3 * curve.length();
    const auto x_s = [&](double t) { return Vector<2>(curve.evaluate(Param<2>(t)).x_s); };
    expect_close(curve.evaluate(Param<2>(s)).x_ss[0], finite_difference(x_s, s, h), 1 / curve.length(), 1e-7,
                 "x_ss");
  }
}

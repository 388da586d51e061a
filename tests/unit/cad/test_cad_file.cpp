// Files: numbers of .geo files, units, what the libraries leave behind, and everything that is refused.
#include "cad/occ/cad_file.hpp"
#include "unit/cad/cad_samples.hpp"
#include "unit/finite_difference.hpp"
#include "unit/geometry/profile_checks.hpp"
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepTools.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Edge.hxx>
#include <clocale>
#include <csignal>
#include <fstream>

using namespace burnish;
using namespace burnish::test;

namespace {

const Param<2> ANY(0.0);

std::string text_of(const std::string& file) {
  std::ifstream stream("tests/support/cad/" + file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

CadCurve opened(const std::string& file, const std::vector<int>& curves = {}, const std::string& numbers = "",
                double scale = 1) {
  return CadCurve({file, curves, scale, numbers, false});
}

/// Points 1 to 4 of a square and its sides 1 to 4; `more` follows.
std::string square(const std::string& more = "") {
  return "Point(1) = {0, 0, 0}; Point(2) = {4, 0, 0}; Point(3) = {4, 4, 0}; Point(4) = {0, 4, 0};\n"
         "Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};\n" +
         more;
}

/// Points 1 to 4 at x = 0, 1, c, 2; `more` follows.
std::string on_a_line(double c, const std::string& more) {
  std::ostringstream text;
  text << std::setprecision(12) << "Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {" << c
       << ", 0, 0}; Point(4) = {2, 0, 0};" << more;
  return text.str();
}

template <class Array, class Values> Array filled(const Values& values) {
  Array array(1, static_cast<int>(values.size()));
  std::copy(values.begin(), values.end(), array.begin());
  return array;
}

/// B-spline through the .brep format; knots and multiplicities of a clamped curve.
CadCurve bspline(const std::vector<Vector<2>>& poles, int degree, std::vector<double> weights,
                 const std::vector<double>& knots, const std::vector<int>& multiplicities) {
  const TemporaryFile file("", ".brep");
  TColgp_Array1OfPnt points(1, static_cast<int>(poles.size()));
  for (std::size_t i = 0; i < poles.size(); ++i)
    points(static_cast<int>(i) + 1) = gp_Pnt(poles[i].x(), poles[i].y(), 0);
  weights.resize(poles.size(), 1);
  const Handle(Geom_Curve) curve = new Geom_BSplineCurve(
      points, filled<TColStd_Array1OfReal>(weights), filled<TColStd_Array1OfReal>(knots),
      filled<TColStd_Array1OfInteger>(multiplicities), degree);
  BRepTools::Write(BRepBuilderAPI_MakeEdge(curve).Edge(), file.path().c_str());
  return opened(file.path());
}

void refuses(const std::string& geo, const std::vector<int>& curves, const std::string& message) {
  expect_invalid([&] { drawn(geo, curves); }, message);
}

} // namespace

TEST(CadFile, NumbersOfAGeoFile) {
  const std::string text =
      "DefineConstant[ R = {2, Name \"Sizes/Radius\"}, H = 1 ];\n"
      "Point(1) = {R, 0, 0}; Point(2) = {0, R, 0}; Point(3) = {0, R + H, 0}; Point(4) = {0, 0, 0};\n"
      "Circle(1) = {1, 4, 2}; Point(5) = {-H, R, 0}; Line(2) = {2, 5};";
  const auto length = [&](const std::string& numbers) { return drawn(text, {}, numbers).length(); };
  EXPECT_NEAR(length(""), M_PI + 1, 1e-12);
  EXPECT_NEAR(length("R=0.25; H=3e-1"), M_PI / 8 + 0.3, 1e-13);
  EXPECT_NEAR(length("H = 7"), M_PI + 7, 1e-12) << "the R of the file before is forgotten";
  EXPECT_NEAR(length(""), M_PI + 1, 1e-12);
}

TEST(CadFile, SeveralFilesAtOnce) {
  const CadCurve lobe = stored("lobe.step"), circle = stored("circle.brep", 1e-3), again = stored("lobe.geo");
  for (double s : {1., 20., 40.}) {
    expect_close(lobe.evaluate(Param<2>(s)).x, again.evaluate(Param<2>(s)).x, 10, 1e-9, "same curve");
    EXPECT_NEAR(circle.evaluate(Param<2>(s)).x.norm(), 15e-3, 1e-15);
  }
}

// Half a circle as a rational spline: its parameter is no angle, its second derivative jumps in the middle.
TEST(CadFile, RationalSpline) {
  const double w = std::sqrt(0.5), R = 7;
  const CadCurve half =
      bspline({{R, 0}, {R, R}, {0, R}, {-R, R}, {-R, 0}}, 2, {1, w, 1, w, 1}, {0, 0.5, 1}, {3, 2, 3});
  EXPECT_NEAR(half.length() / (M_PI * R), 1, 1e-13);
  EXPECT_NEAR(half.tightest_radius() / R, 1, 1e-10);
  for (double part = 0.02; part < 1; part += 0.05) {
    const auto at = half.evaluate(Param<2>(part * half.length()));
    EXPECT_NEAR(at.x.norm() / R, 1, 1e-14);
    expect_close(at.n, Vector<2>(-at.x / R), 1, 1e-12, "left of counter-clockwise");
    expect_close(at.n_s, Vector<2>(-at.x_s / R), 1 / R, 1e-10, "n_s"); // needs x_ss
  }
}

// Knots at uneven places, single and double: found well enough for derivatives on either side of them.
TEST(CadFile, KnotsOfASpline) {
  std::vector<Vector<2>> poles;
  for (int i = 0; i < 12; ++i) poles.emplace_back(i, 2 * std::sin(1.1 * i) + 0.3 * std::cos(3. * i));
  const std::vector<double> knots{0, 0.1, 0.35, 0.36, 0.7, 0.9, 1};
  const CadCurve curve = bspline(poles, 4, {}, knots, {5, 1, 2, 1, 2, 1, 5});
  const double L = curve.length();
  for (const double knot : {0.1, 0.35, 0.36, 0.7, 0.9})
    for (const double aside : {-5e-5, 5e-5}) check_profile_derivatives(curve, (knot + aside) * L, 0.02 * L);
}

TEST(CadFileErrors, BreaksInsideACurve) {
  const std::vector<Vector<2>> corner{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 1}, {5, 2}, {6, 4}},
      faster{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {5, 0}, {7, 1}, {9, 2}};
  for (const double knot : {0.37, 0.5}) // 0.5 is hit by halving
    expect_invalid(
        [&] {
          bspline(corner, 3, {}, {0, knot, 1}, {4, 3, 4});
        },
        "has a corner of 45 degrees at (3, 0); round it with a fillet");
  expect_invalid(
      [&] {
        bspline(faster, 3, {}, {0, 0.37, 1}, {4, 3, 4});
      },
      "changes its speed suddenly at (3, 0); split it there");
}

// A STEP file knows its unit, and OpenCASCADE turns it into mm.
TEST(CadFile, StepFilesArriveInMillimeters) {
  std::string text = text_of("circle.step");
  const std::string millimeter = "SI_UNIT(.MILLI.,.METRE.)", meter = "SI_UNIT($,.METRE.)";
  ASSERT_NE(text.find(millimeter), std::string::npos);
  text.replace(text.find(millimeter), millimeter.size(), meter);
  const TemporaryFile file(text, ".step");
  EXPECT_NEAR(opened(file.path()).tightest_radius(), 15e3, 1e-6);
  EXPECT_NEAR(opened(file.path(), {}, "", 1e-3).tightest_radius(), 15, 1e-9);
}

// OpenCASCADE prints on bad STEP files and catches signals, gmsh changes the locale: nothing of it may be seen.
TEST(CadFile, LeavesNothingBehindInTheProcess) {
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  std::vector<struct sigaction> before(NSIG), after(NSIG);
  std::signal(SIGUSR1, SIG_IGN);
  for (int i = 1; i < NSIG; ++i) sigaction(i, nullptr, &before[i]);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string cut = text_of("lobe.step"), nan = text_of("circle.brep");
  const TemporaryFile bad(cut.substr(0, cut.size() / 2), ".step"), worse(nan.substr(0, 200), ".brep");
  EXPECT_THROW(opened(bad.path()), std::invalid_argument);
  EXPECT_THROW(opened(worse.path()), std::invalid_argument);
  EXPECT_THROW(drawn("Printf(\"hello\"); Point(1) = {0, 0, 0;"), std::invalid_argument);
  const CadCurve circle = stored("circle.step"), drawing = drawn(square("Line(5) = {1, 3};"), {5});
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(std::setlocale(LC_ALL, nullptr), locale);
  for (int i = 1; i < NSIG; ++i) {
    sigaction(i, nullptr, &after[i]);
    EXPECT_EQ(before[i].sa_handler, after[i].sa_handler) << "signal " << i;
    EXPECT_EQ(before[i].sa_flags, after[i].sa_flags) << "signal " << i;
  }
}

TEST(CadFileErrors, Files) {
  expect_invalid([] { opened("nowhere.step"); },
                 "CadFile: \"nowhere.step\" does not exist, seen from folder");
  expect_invalid([] { opened("tests"); }, "\"tests\" is a folder");
  expect_invalid([] { opened("README.md"); }, "ends in \".md\", expected .geo, .step, .stp or .brep");
  const TemporaryFile empty(" \n", ".geo"), text("hello\n", ".step"), brep("hello\n", ".brep"),
      pointless("Point(1) = {0, 0, 0};\n", ".geo"),
      endless("Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0};", ".geo");
  expect_invalid([&] { opened(empty.path()); }, "is empty");
  expect_invalid([&] { opened(text.path()); }, "is no STEP file: it does not begin with \"ISO-10303-21\"");
  expect_invalid([&] { opened(brep.path()); },
                 "is no BREP file: it does not begin with \"CASCADE Topology\"");
  expect_invalid([&] { opened(pointless.path()); }, "no curves in it");
  expect_invalid([&] { opened(endless.path()); }, "does not end with a new line");
  expect_invalid([] { drawn("Point(1) = {0, 0, 0;"); }, "line 1: syntax error");
  expect_invalid([] { drawn("Line(1) = {1, 2};"); }, "Unknown control point 1 in GEO curve 1");
  EXPECT_NEAR(drawn(square(), {1}).length(), 4, 1e-14) << "the errors before left nothing";
}

TEST(CadFileErrors, Numbers) {
  const std::string text = "DefineConstant[ R = 2 ];\nH = 1;\nPoint(1) = {R, 0, 0};\nPoint(2) = {0, H, 0};\n"
                           "Line(1) = {1, 2};";
  EXPECT_NEAR(drawn(text, {}, "R=1").length(), std::sqrt(2), 1e-15);
  expect_invalid([&] { drawn(text, {}, "Q=1"); }, "has no number \"Q\"");
  expect_invalid([&] { drawn("// Q is the width\n/* Q */ " + text, {}, "Q=1"); },
                 "has no number \"Q\""); // in comments only
  expect_invalid([&] { drawn(text, {}, "H=5"); },
                 "it gives H another value, 1; write DefineConstant[ H = ... ] there");
  expect_invalid([&] { drawn(text, {}, "R=2; R=3"); }, "number \"R\" is given twice");
  for (const char* wrong : {"R", "R=", "=3", "R=2mm", "R=nan", "2R=3", "R 2", "R=1=2"})
    expect_invalid([&] { drawn(text, {}, wrong); },
                   std::string("CadCurve: \"") + wrong +
                       "\" is no number for the geometry, expected name=value");
  expect_invalid([] { opened("tests/support/cad/circle.step", {}, "R=1"); },
                 "takes no numbers, only .geo files do");
}

TEST(CadFileErrors, Tags) {
  const std::string text = square("Curve Loop(20) = {1, 2, 3, 4};\nPlane Surface(7) = {20};");
  refuses(text, {1, 9}, "has no curve 9, its curves are 1, 2, 3, 4");
  refuses(text, {7}, "has no curve 7 (there is a surface of that tag), its curves are");
  refuses(text, {-1}, "has no curve -1");
  refuses(text, {1, 2, 1}, "curve 1 is given twice");
}

TEST(CadFileErrors, Chains) {
  refuses(square(), {},
          "curves 1 and 2 make a corner of 90 degrees at (4, 0); round it with a fillet in the CAD system: "
          "radius ");
  refuses(on_a_line(1.5, "Line(1) = {2, 1}; Line(2) = {3, 4};"), {},
          "the curves do not join into one chain: 1 and apart from them 2; their nearest ends are those of "
          "curve 1 at (1, 0) and of curve 2 at (1.5, 0)");
  refuses(on_a_line(1.00002, "Line(1) = {1, 2}; Line(2) = {3, 4};"), {}, "do not join"); // size 2
  EXPECT_NEAR(drawn(on_a_line(1.000001, "Line(1) = {1, 2}; Line(2) = {3, 4};")).length(), 2, 2e-6);
  refuses(square("Line(5) = {2, 4};"), {}, "the chain branches at (4, 0): curves 1, 2, 5 meet there");
  refuses(square("Bezier(5) = {1, 2, 3, 1};"), {5}, "curve 5 closes with a corner of 135 degrees at (0, 0)");
  refuses("Point(1) = {0, 0, 0}; Point(2) = {6, 4, 0}; Point(3) = {-2, 4, 0}; Point(4) = {4, 0, 0};"
          "Bezier(1) = {1, 2, 3, 4};",
          {}, "the chain crosses or touches itself near (1.99999, 1.71428): curve 1 with itself");
  refuses(square("Bezier(5) = {1, 1, 1, 3};"), {5}, "curve 5 has no tangent at");
}

TEST(CadFileErrors, PlaneAndScale) {
  const std::string line = "Line(1) = {1, 2};";
  refuses("Point(1) = {0, 0, 3}; Point(2) = {1, 0, 3};" + line, {},
          "is not in the plane z = 0: it passes through (0, 0, 3)");
  refuses("Point(1) = {0, 0, 0}; Point(2) = {1, 0, -0.5};" + line, {}, "through (1, 0, -0.5)");
  for (const double scale : {0., -1., std::nan("")})
    expect_invalid([&] { drawn(square(), {1}, "", scale); }, "CadCurve: scale = ");
}

TEST(CadFileErrors, PointsAndParameters) {
  const CadCurve curve = drawn(square(), {1});
  const double nan = std::nan("");
  expect_invalid([&] { curve.evaluate(Param<2>(nan)); }, "CadCurve::evaluate: s = nan, expected a finite");
  expect_invalid([&] { curve.piece(Param<2>(nan)); }, "CadCurve::piece: s = nan");
  expect_invalid([&] { curve.closest_point({nan, 0}, ANY); }, "CadCurve::closest_point: x = nan   0");
  expect_invalid([&] { curve.closest_point({0, 0}, Param<2>(nan)); }, "CadCurve::closest_point: near = nan");
}

// Random splines of .geo files, both kernels of gmsh: refused with a clear error, or a curve whose
// derivatives and closest points are right.
#include "long/fuzz.hpp"
#include "unit/cad/cad_samples.hpp"
#include <iostream>
#include <map>

using namespace burnish;
using namespace burnish::test;

namespace {

/// A spline through or near random points, scribbled or about a center, perhaps moved, turned, blown up.
std::string drawing(Random& random) {
  const int n = random.whole(2, 12);
  const bool closed = n > 3 && random.chance(0.5), scribbled = random.chance(0.3);
  const double size = random.decades(-2, 3), turn = (random.chance(0.5) ? -2 : 2) * M_PI / n;
  std::ostringstream text;
  text.precision(random.whole(3, 16));
  if (random.chance(0.5)) text << "SetFactory(\"OpenCASCADE\");\n";
  for (int i = 0; i < n; ++i) {
    const double angle = turn * (i + random.between(-0.3, 0.3)), r = size * random.between(0.6, 1);
    const Vector<2> x = scribbled ? random.point(size)
                        : closed  ? Vector<2>(r * std::cos(angle), r * std::sin(angle))
                                  : Vector<2>(size * (i + random.between(-0.3, 0.3)), r);
    text << "Point(" << i + 1 << ") = {" << x.x() << ", " << x.y() << ", 0};\n";
  }
  const char* kinds[] = {"Spline", "BSpline", "Bezier"};
  const int kind = random.whole(0, closed ? 1 : 2);
  text << kinds[kind] << "(1) = {1:" << n << (closed ? ", 1" : "") << "};\n";
  if (random.chance(0.3))
    text << "Rotate {{0, 0, 1}, {" << size << ", 0, 0}, " << random.between(-3, 3) << "} {Curve{1};}\n";
  if (random.chance(0.2)) text << "Dilate {{0, 0, 0}, " << random.decades(-1, 2) << "} {Curve{1};}\n";
  if (random.chance(0.2)) text << "Translate {" << 100 * size << ", " << -30 * size << ", 0} {Curve{1};}\n";
  return text.str();
}

/// x_s and x_ss against the course of the points; a central difference is wrong where a knot is near, so by
/// integrals: x(b) - x(a) is the integral of x_s, and likewise x_s, over spans that may hold knots.
void check_derivatives(const CadCurve& curve, Random& random) {
  const double L = curve.length(), radius = std::min(curve.tightest_radius(), L);
  const int parts = 400;
  for (int k = 0; k < 5; ++k) {
    const double a = L * random.between(0, 0.95), step = std::min(0.01 * L, 0.5 * radius) / parts;
    Vector<2> x = Vector<2>::Zero(), x_s = x;
    double most = 0;
    for (int i = 0; i < parts; ++i) {
      const auto at = curve.evaluate(Param<2>(a + (i + 0.5) * step));
      x += step * at.x_s;
      x_s += step * at.x_ss[0];
      most = std::max(most, at.x_ss[0].norm());
    }
    const auto begin = curve.evaluate(Param<2>(a)), end = curve.evaluate(Param<2>(a + parts * step));
    ASSERT_LE((end.x - begin.x - x).norm(), 1e-4 * parts * step);
    ASSERT_LE((end.x_s - begin.x_s - x_s).norm(), 1e-4 + 2 * step * most);
  }
}

/// The curve of a drawing as a polygon, before anything is checked.
std::vector<Vector<2>> polygon(const std::string& text) {
  const TemporaryFile file(text + "\n", ".geo");
  CadSelection selection;
  selection.file = file.path();
  const CadPiece piece = read_curves(selection)[0];
  std::vector<Vector<2>> line;
  for (int i = 0; i <= 600; ++i) line.push_back(piece.at(piece.length() * i / 600).x);
  return line;
}

bool meets_itself(const std::string& text, bool touching) {
  const auto line = polygon(text);
  double length = 0, longest = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length += (line[i] - line[i - 1]).norm();
    longest = std::max(longest, (line[i] - line[i - 1]).norm());
  }
  const bool closed = (line.front() - line.back()).norm() <= 1e-6 * length;
  return polygon_meets_itself(line, closed, touching ? longest : 0, touching ? 4 * longest : 1e-6 * length);
}

} // namespace

TEST(FuzzCadCurve, Splines) {
  Random random(1);
  std::map<std::string, int> counts;
  for (int i = 0; i < 700 && !HasFailure(); ++i) {
    const std::string text = drawing(random);
    SCOPED_TRACE(text);
    try {
      const CadCurve curve = drawn(text);
      ++counts["accepted"];
      ASSERT_FALSE(meets_itself(text, false));
      check_derivatives(curve, random);
      if (!HasFatalFailure()) check_closest_points(curve, random, 30, 1e-11, 1e-8);
    } catch (const std::invalid_argument& error) {
      const std::string said = error.what();
      bool known = false;
      for (const char* reason : {"corner", "crosses", "no length", "turns back", "no tangent"}) {
        if (known || said.find(reason) == std::string::npos) continue;
        known = true;
        ++counts[reason];
      }
      EXPECT_TRUE(known) << said;
      EXPECT_TRUE(said.find("crosses") == std::string::npos || meets_itself(text, true)) << said;
    }
  }
  for (const auto& [what, n] : counts) std::cout << "  " << n << " " << what << "\n";
  EXPECT_GE(counts["accepted"], 300);
}

#pragma once
// CAD files for the tests: the ones of tests/support/cad and others written on the spot.
#include "base/temporary.hpp"
#include "cad/occ/cad_curve.hpp"
#include "geometry/arc_chain.hpp"
#include "geometry/plane.hpp"
#include <iomanip>

namespace burnish::test {

inline CadCurve stored(const std::string& name, double scale = 1, bool inside = false) {
  CadSelection selection;
  selection.file = "tests/support/cad/" + name;
  selection.scale = scale;
  selection.inside = inside;
  return CadCurve(selection);
}

/// The profile of a .geo text. @param curves tags, empty: all
inline CadCurve drawn(const std::string& text, const std::vector<int>& curves = {},
                      const std::string& numbers = "", double scale = 1) {
  const TemporaryFile file(text + "\n", ".geo");
  CadSelection selection;
  selection.file = file.path();
  selection.curves = curves;
  selection.numbers = numbers;
  selection.scale = scale;
  return CadCurve(selection);
}

const char* const OPENCASCADE = "SetFactory(\"OpenCASCADE\");\n";

/// Lines and arcs of a chain as .geo text, curve i + 1 for piece i.
inline std::string geo_of(const ArcChain& chain) {
  std::ostringstream text;
  text << std::setprecision(17);
  const auto& pieces = chain.pieces();
  const int n = static_cast<int>(pieces.size()), last = chain.closed() ? n : n + 1;
  for (int i = 0; i < last; ++i) {
    const Vector<2> x = i < n ? pieces[i].start : pieces[n - 1].point(pieces[n - 1].length);
    text << "Point(" << i + 1 << ") = {" << x.x() << ", " << x.y() << ", 0};\n";
  }
  for (int i = 0; i < n; ++i) {
    const int to = i + 1 < last ? i + 2 : 1;
    if (pieces[i].curvature == 0) {
      text << "Line(" << i + 1 << ") = {" << i + 1 << ", " << to << "};\n";
      continue;
    }
    const Vector<2> center = pieces[i].start + left_of(pieces[i].tangent) / pieces[i].curvature;
    text << "Point(" << 101 + i << ") = {" << center.x() << ", " << center.y() << ", 0};\nCircle(" << i + 1
         << ") = {" << i + 1 << ", " << 101 + i << ", " << to << "};\n";
  }
  return text.str();
}

/// Splines of each kind; the first is open, the others closed loops.
inline std::string spline_points() {
  return "For i In {0:8}\n a = 2*Pi*i/9;\n r = 10*(1 + 0.25*Cos(a) + 0.1*Sin(2*a));\n"
         " Point(i + 1) = {r*Cos(a), r*Sin(a), 0};\nEndFor\n";
}

} // namespace burnish::test

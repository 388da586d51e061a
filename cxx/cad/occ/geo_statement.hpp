#pragma once
// Statements of a .geo text in which all numbers are plain: what gmsh writes as geo_unrolled.
#include <string>
#include <vector>

namespace burnish {

/// WORD(tag) = {numbers} Knots {knots} Order n;
struct GeoStatement {
  std::string word; ///< Point, Line, Circle, ...
  int tag = 0;
  std::vector<double> numbers;
  std::vector<int> points; ///< the numbers, as tags
  std::vector<double> knots;
  int order = 0;
};

/// All statements of this form, in their order; others (Physical Curve, fields, assignments) are left out.
std::vector<GeoStatement> geo_statements(const std::string& text);

} // namespace burnish

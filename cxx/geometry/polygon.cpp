#include "geometry/polygon.hpp"
#include "geometry/plane.hpp"
#include <algorithm>
#include <numeric>

namespace burnish {
namespace {

double area(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c) { return cross(b - a, c - a) / 2; }

} // namespace

std::vector<std::array<int, 3>> polygon_triangles(const std::vector<Vector<2>>& corners) {
  std::vector<int> left(corners.size());
  std::iota(left.begin(), left.end(), 0);
  const auto at = [&](int i) -> const Vector<2>& { return corners[static_cast<std::size_t>(i)]; };
  double whole = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    whole += cross(corners[i], corners[(i + 1) % corners.size()]) / 2;
  if (whole < 0) std::reverse(left.begin(), left.end());
  const double nothing = 1e-14 * std::abs(whole);
  std::vector<std::array<int, 3>> triangles;
  const auto is_ear = [&](int a, int b, int c) {
    if (area(at(a), at(b), at(c)) <= nothing) return false;
    return std::none_of(left.begin(), left.end(), [&](int i) {
      return i != a && i != b && i != c && area(at(a), at(b), at(i)) > nothing &&
             area(at(b), at(c), at(i)) > nothing && area(at(c), at(a), at(i)) > nothing;
    });
  };
  const auto is_flat = [&](int a, int b, int c) { return std::abs(area(at(a), at(b), at(c))) <= nothing; };
  std::size_t i = 0, tried = 0;
  while (left.size() >= 3 && tried < left.size()) {
    const std::size_t n = left.size();
    const int a = left[(i + n - 1) % n], b = left[i % n], c = left[(i + 1) % n];
    const bool ear = is_ear(a, b, c);
    if (ear) triangles.push_back({a, b, c});
    if (ear || is_flat(a, b, c)) {
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i % n));
      tried = 0;
    } else {
      ++i;
      ++tried;
    }
    i %= std::max<std::size_t>(left.size(), 1);
  }
  return triangles;
}

} // namespace burnish

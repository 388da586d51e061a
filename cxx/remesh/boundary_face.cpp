#include "remesh/boundary_face.hpp"
#include "mesh/facet_measure.hpp"
#include "remesh/parabola.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr int NEWTON = 20;      // iterations from the middle of a face to the foot of a place
constexpr double FOUND = 1e-14; // of the coordinates

Barycentric<2> coordinates(double a, double b) { return {1 - a - b, a, b}; }

Parabola<3> edge(const FaceNodes& x, int i) {
  const auto [a, b] = SimplexEdges<2>::ends[i];
  return {x[a], x.size() > 3 ? x[3 + i] : Vector<3>(0.5 * (x[a] + x[b])), x[b]};
}

} // namespace

Vector<3> place_on(const FaceNodes& x, const Barycentric<2>& l) {
  double N[6];
  shape_functions<2>(static_cast<int>(x.size()), l, N);
  Vector<3> place = Vector<3>::Zero();
  for (std::size_t a = 0; a < x.size(); ++a) place += N[a] * x[a];
  return place;
}

// The foot, if it is inside, else the nearest place of an edge.
std::pair<Vector<3>, double> nearest_on(const FaceNodes& x, const Vector<3>& p) {
  Eigen::Vector2d at(1. / 3, 1. / 3);
  bool found = false;
  for (int i = 0; i < NEWTON && !found; ++i) {
    const Barycentric<2> l = coordinates(at[0], at[1]);
    const auto T = triangle_tangents(x, l);
    const Eigen::Vector2d move = (T.transpose() * T).ldlt().solve(T.transpose() * (p - place_on(x, l)));
    at = (at + move).cwiseMax(-1).cwiseMin(2);
    found = move.norm() < FOUND;
  }
  const Barycentric<2> l = coordinates(at[0], at[1]);
  if (l.minCoeff() >= 0) {
    const Vector<3> foot = place_on(x, l);
    return {foot, (foot - p).squaredNorm()};
  }
  auto best = nearest_on_parabola<3>(edge(x, 0), p);
  for (const int i : {1, 2}) {
    const auto other = nearest_on_parabola<3>(edge(x, i), p);
    if (other.second < best.second) best = other;
  }
  return best;
}

double volume_behind(const FaceNodes& x) {
  double sum = 0;
  for (const TrianglePoint& point : triangle_rule()) {
    const auto T = triangle_tangents(x, point.l);
    sum += point.weight / 3 * place_on(x, point.l).dot(T.col(0).cross(T.col(1)));
  }
  return sum;
}

} // namespace burnish

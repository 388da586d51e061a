#include "mesh/facet_measure.hpp"
#include "mesh/simplex.hpp"
#include <cmath>

namespace burnish {
namespace {

/// dA/dl1 dl2 at barycentric coordinates l of a triangle in space [area].
double area_density(const std::vector<Vector<3>>& x, const Barycentric<2>& l) {
  const auto tangents = triangle_tangents(x, l);
  return tangents.col(0).cross(tangents.col(1)).norm();
}

} // namespace

Eigen::Matrix<double, 3, 2> triangle_tangents(const std::vector<Vector<3>>& x, const Barycentric<2>& l) {
  const std::array<Vector<2>, 3> gradient{Vector<2>(-1, -1), Vector<2>(1, 0), Vector<2>(0, 1)};
  Eigen::Matrix<double, 3, 2> tangents = Eigen::Matrix<double, 3, 2>::Zero();
  const int nodes = static_cast<int>(x.size());
  for (int a = 0; a < nodes; ++a) tangents += x[a] * shape_gradient<2, 2>(nodes, l, gradient, a).transpose();
  return tangents;
}

Eigen::MatrixXd EdgeMeasure::masses(const std::vector<Vector<2>>& x) const {
  const bool quadratic = x.size() == 3;
  const Vector<2>&a = x[0], &b = x[1];
  const Vector<2> m = quadratic ? x[2] : Vector<2>(0.5 * (a + b));
  const double length = (m - a).norm() + (b - m).norm();
  const double point[] = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)}, // Gauss, exact to degree 5
      weight[] = {5. / 18, 4. / 9, 5. / 18};
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(x.size()), 2);
  for (int g = 0; g < 3; ++g) {
    const double s = point[g], t = 1 - s;
    Eigen::Vector3d N(t, s, 0);
    if (quadratic) N = {t * (t - s), s * (s - t), 4 * s * t};
    const double r = quadratic ? N[0] * a.x() + N[1] * b.x() + N[2] * m.x() : t * a.x() + s * b.x();
    const double area = weight[g] * length * (m_axisymmetric ? 2 * std::acos(-1.) * r : 1);
    mass += area * N.head(mass.rows()) * Eigen::RowVector2d(t, s);
  }
  return mass;
}

const std::array<TrianglePoint, 7>& triangle_rule() {
  static const std::array<TrianglePoint, 7> points = [] {
    const double root = std::sqrt(15.); // Radon's rule: the centroid and two rings of three points
    const double other[] = {1. / 3, (6 - root) / 21, (6 + root) / 21};
    const double weight[] = {9. / 80, (155 - root) / 2400, (155 + root) / 2400};
    std::array<TrianglePoint, 7> rule;
    for (int point = 0; point < 7; ++point) {
      const int ring = (point + 2) / 3;
      Barycentric<2> l = Barycentric<2>::Constant(other[ring]);
      if (ring > 0) l[(point + 2) % 3] = 1 - 2 * other[ring];
      rule[point] = {l, weight[ring]};
    }
    return rule;
  }();
  return points;
}

Eigen::MatrixXd FaceMeasure::masses(const std::vector<Vector<3>>& x) const {
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(x.size()), 3);
  for (const auto& [l, weight] : triangle_rule()) {
    double N[6];
    shape_functions<2>(static_cast<int>(x.size()), l, N);
    mass += weight * area_density(x, l) * Eigen::Map<Eigen::VectorXd>(N, mass.rows()) * l.transpose();
  }
  return mass;
}

} // namespace burnish

#include "mesh/facet_measure.hpp"
#include <cmath>

namespace burnish {

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

} // namespace burnish

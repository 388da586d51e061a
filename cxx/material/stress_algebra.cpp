#include "material/stress_algebra.hpp"
#include <Eigen/Eigenvalues>

namespace burnish {

std::array<double, 2> extreme_principals(const Stress<3>& t) {
  const Eigen::SelfAdjointEigenSolver<Tensor<3>> solver(matrix_of<3>(t), Eigen::EigenvaluesOnly);
  return {solver.eigenvalues()[2], solver.eigenvalues()[0]};
}

Stress<3> rotated(const Stress<3>& t, const Tensor<3>& R) {
  return stress_of(R * matrix_of<3>(t) * R.transpose());
}

Eigen::Matrix<double, 6, 3> spin_rate(const Stress<3>& t) {
  Eigen::Matrix<double, 6, 3> rate;
  rate.col(0) << 0, -2 * t[4], 2 * t[4], -t[5], t[1] - t[2], t[3];
  rate.col(1) << 2 * t[5], 0, -2 * t[5], t[4], -t[3], t[2] - t[0];
  rate.col(2) << -2 * t[3], 2 * t[3], 0, t[0] - t[1], t[5], -t[4];
  return rate;
}

} // namespace burnish

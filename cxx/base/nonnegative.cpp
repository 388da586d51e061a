#include "base/nonnegative.hpp"
#include <Eigen/QR>
#include <vector>

namespace burnish {
namespace {

constexpr double RISES =
    1e-12; // slope along a number at 0, over the lengths of its column and of b, that counts

} // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(A.cols());
  std::vector<int> used; // columns whose number is above 0
  for (Eigen::Index turn = 0; turn < 3 * A.cols(); ++turn) {
    const Eigen::VectorXd slope = A.transpose() * (b - A * x);
    int best = -1;
    double steepest = RISES * b.norm();
    for (int j = 0; j < slope.size(); ++j) {
      const double length = A.col(j).norm();
      if (x[j] > 0 || !(slope[j] > steepest * length)) continue;
      steepest = slope[j] / length;
      best = j;
    }
    if (best < 0) break;
    used.push_back(best);
    for (;;) {
      const Eigen::VectorXd full = A(Eigen::all, used).completeOrthogonalDecomposition().solve(b);
      double part = 1; // of the way there, to where the first number would fall below 0
      for (std::size_t k = 0; k < used.size(); ++k)
        if (full[static_cast<Eigen::Index>(k)] <= 0)
          part = std::min(part, x[used[k]] / (x[used[k]] - full[static_cast<Eigen::Index>(k)]));
      std::vector<int> kept;
      for (std::size_t k = 0; k < used.size(); ++k) {
        double& number = x[used[k]];
        number += part * (full[static_cast<Eigen::Index>(k)] - number);
        if (part < 1 && number <= RISES * x.maxCoeff()) number = 0;
        if (number > 0) kept.push_back(used[k]);
      }
      const bool done = part >= 1 || kept.empty();
      used = std::move(kept);
      if (done) break;
    }
  }
  return x;
}

} // namespace burnish

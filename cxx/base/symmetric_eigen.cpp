#include "base/symmetric_eigen.hpp"
#include <Eigen/Eigenvalues>

namespace burnish {

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace burnish

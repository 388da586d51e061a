#include "base/decompositions.hpp"
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

// LAPACK: eigenvalues of an unsymmetric matrix, singular values.
extern "C" void dgeev_(const char* left, const char* right, const int* n, double* a, const int* lda,
                       double* real, double* imaginary, double* vl, const int* ldvl, double* vr,
                       const int* ldvr, double* work, const int* lwork, int* info, std::size_t left_length,
                       std::size_t right_length);
extern "C" void dgesvd_(const char* left, const char* right, const int* rows, const int* columns, double* a,
                        const int* lda, double* values, double* u, const int* ldu, double* vt,
                        const int* ldvt, double* work, const int* lwork, int* info, std::size_t left_length,
                        std::size_t right_length);

namespace burnish {
namespace {

constexpr double NOT_FOUND = std::numeric_limits<double>::quiet_NaN();

} // namespace

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

double least_real_part(Eigen::MatrixXd A) {
  const int n = static_cast<int>(A.rows()), one = 1, size = 4 * n;
  Eigen::VectorXd real(n), imaginary(n), work(size);
  int info = 0;
  dgeev_("N", "N", &n, A.data(), &n, real.data(), imaginary.data(), nullptr, &one, nullptr, &one, work.data(),
         &size, &info, 1, 1);
  return info == 0 ? real.minCoeff() : NOT_FOUND;
}

RightSingular right_singular(Eigen::MatrixXd A) {
  const int rows = static_cast<int>(A.rows()), columns = static_cast<int>(A.cols()), one = 1;
  const int size = 5 * std::max(rows, columns);
  RightSingular result{Eigen::VectorXd(std::min(rows, columns)), Eigen::MatrixXd(columns, columns)};
  Eigen::VectorXd work(size);
  int info = 0;
  dgesvd_("N", "A", &rows, &columns, A.data(), &rows, result.values.data(), nullptr, &one,
          result.vectors.data(), &columns, work.data(), &size, &info, 1, 1);
  result.vectors.transposeInPlace();
  if (info != 0) result.values.setConstant(NOT_FOUND);
  return result;
}

template <int Terms>
Eigen::Matrix<double, Terms, 1> first_of_inverse(const Eigen::Matrix<double, Terms, Terms>& normal) {
  const Eigen::Matrix<double, Terms, 1> unit = Eigen::Matrix<double, Terms, 1>::Unit(0);
  return normal.ldlt().solve(unit);
}

template Eigen::Matrix<double, 3, 1> first_of_inverse(const Eigen::Matrix<double, 3, 3>&);
template Eigen::Matrix<double, 4, 1> first_of_inverse(const Eigen::Matrix<double, 4, 4>&);

} // namespace burnish

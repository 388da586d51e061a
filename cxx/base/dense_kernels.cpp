#include "base/dense_kernels.hpp"
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <vector>

// BLAS and LAPACK.
extern "C" {
void dtrsm_(const char* side, const char* triangle, const char* transposed, const char* unit, const int* rows,
            const int* columns, const double* scale, const double* a, const int* lda, double* b,
            const int* ldb, std::size_t, std::size_t, std::size_t, std::size_t);
void dgemm_(const char* transposed, const char* other, const int* rows, const int* columns, const int* inner,
            const double* scale, const double* a, const int* lda, const double* b, const int* ldb,
            const double* kept, double* c, const int* ldc, std::size_t, std::size_t);
void dpotrf_(const char* triangle, const int* n, double* a, const int* lda, int* info, std::size_t);
void dtrtri_(const char* triangle, const char* unit, const int* n, double* a, const int* lda, int* info,
             std::size_t, std::size_t);
void dtrmm_(const char* side, const char* triangle, const char* transposed, const char* unit, const int* rows,
            const int* columns, const double* scale, const double* a, const int* lda, double* b,
            const int* ldb, std::size_t, std::size_t, std::size_t, std::size_t);
void dlauum_(const char* triangle, const int* n, double* a, const int* lda, int* info, std::size_t);
void dgetrf_(const int* rows, const int* columns, double* a, const int* lda, int* pivots, int* info);
void dgecon_(const char* norm, const int* n, const double* a, const int* lda, const double* norm_of_a,
             double* rcond, double* work, int* places, int* info, std::size_t);
void dgetrs_(const char* transposed, const int* n, const int* columns, const double* a, const int* lda,
             const int* pivots, double* b, const int* ldb, int* info, std::size_t);
}

namespace burnish {
namespace {

int number(Eigen::Index n) { return static_cast<int>(n); }

// L^-1 in place, by halves: OpenBLAS's dtrtri takes three times as long from a hundred rows on.
void invert_lower(double* L, int n, int stride) {
  constexpr int small = 48;
  int info = 0;
  if (n <= small) return dtrtri_("L", "N", &n, L, &stride, &info, 1, 1);
  const int upper = n / 2, rest = n - upper;
  const double one = 1, minus = -1;
  double *const below = L + upper, *const last = below + static_cast<std::ptrdiff_t>(upper) * stride;
  invert_lower(L, upper, stride);
  invert_lower(last, rest, stride);
  dtrmm_("R", "L", "N", "N", &rest, &upper, &minus, L, &stride, below, &stride, 1, 1, 1, 1);
  dtrmm_("L", "L", "N", "N", &rest, &upper, &one, last, &stride, below, &stride, 1, 1, 1, 1);
}

bool solve_regular_large(Eigen::MatrixXd A, double least, Eigen::VectorXd& x) {
  const int n = number(A.rows()), one = 1;
  const double norm = A.cwiseAbs().colwise().sum().maxCoeff();
  double rcond = 0;
  int info = 0;
  std::vector<int> pivots(n), places(n);
  std::vector<double> work(4 * static_cast<std::size_t>(n));
  dgetrf_(&n, &n, A.data(), &n, pivots.data(), &info);
  if (info != 0) return false;
  dgecon_("1", &n, A.data(), &n, &norm, &rcond, work.data(), places.data(), &info, 1);
  if (info != 0 || !(rcond > least)) return false;
  dgetrs_("N", &n, &one, A.data(), &n, pivots.data(), x.data(), &n, &info, 1);
  return info == 0;
}

} // namespace

bool cholesky(Eigen::MatrixXd& A) {
  if (A.rows() < LARGE_BLOCK)
    return Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(A).info() == Eigen::Success; // in place
  const int n = number(A.rows());
  int info = 0;
  dpotrf_("L", &n, A.data(), &n, &info, 1);
  return info == 0;
}

void solve_lower(const MatrixPart& L, bool transposed, Eigen::MatrixXd& X) {
  if (L.rows >= LARGE_BLOCK) {
    const int rows = number(X.rows()), columns = number(X.cols());
    const double one = 1;
    dtrsm_("L", "L", transposed ? "T" : "N", "N", &rows, &columns, &one, L.values, &L.stride, X.data(), &rows,
           1, 1, 1, 1);
    return;
  }
  const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> part(L.values, L.rows, L.rows,
                                                                        Eigen::OuterStride<>(L.stride));
  if (transposed)
    part.triangularView<Eigen::Lower>().transpose().solveInPlace(X);
  else
    part.triangularView<Eigen::Lower>().solveInPlace(X);
}

Eigen::MatrixXd inverse_from_cholesky(const Eigen::MatrixXd& L, Eigen::Index n) {
  Eigen::MatrixXd inverse = L.topLeftCorner(n, n);
  const int rows = number(n);
  int info = 0;
  if (n == 0) return inverse;
  invert_lower(inverse.data(), rows, rows);
  dlauum_("L", &rows, inverse.data(), &rows, &info, 1);
  inverse.triangularView<Eigen::StrictlyUpper>() = inverse.transpose();
  return inverse;
}

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  if (A.rows() < LARGE_BLOCK) return A.transpose() * B;
  const Eigen::SparseMatrix<double> sparse = A.sparseView();
  return sparse.transpose() * B;
}

void multiply(const MatrixPart& A, bool transposed, const Eigen::MatrixXd& B, Eigen::MatrixXd& C) {
  const int rows = number(C.rows()), columns = number(C.cols()), inner = number(B.rows());
  const double one = 1, none = 0;
  if (C.size() == 0) return;
  dgemm_(transposed ? "T" : "N", "N", &rows, &columns, &inner, &one, A.values, &A.stride, B.data(), &inner,
         &none, C.data(), &rows, 1, 1);
}

bool solve_regular(const Eigen::MatrixXd& A, double least, Eigen::VectorXd& x) {
  if (A.rows() >= LARGE_BLOCK) return solve_regular_large(A, least, x);
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(A);
  const bool pivots = lu.matrixLU().diagonal().cwiseAbs().minCoeff() > 0; // rcond takes them for granted
  if (!pivots || !(lu.rcond() > least)) return false;
  x = lu.solve(x);
  return true;
}

} // namespace burnish

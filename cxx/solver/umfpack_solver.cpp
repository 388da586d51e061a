#include "solver/umfpack_solver.hpp"
#include "solver/sparse_rows.hpp"
#include <algorithm>
#include <new>
#include <suitesparse/umfpack.h>
#include <vector>

namespace burnish {
namespace {

constexpr int MANY = 4; // right-hand sides from which on they are swept together

// L by rows, U by columns and the permutations and scales of P R A Q = L U, with unit diagonal of L and that of U apart.
struct Factors {
  std::vector<int> l_start, l_col, u_start, u_row, p, q;
  std::vector<double> l, u, diagonal, scale;
};

} // namespace

struct UmfpackSolver::Impl {
  int n = 0;
  std::vector<int> start, index, slot; // by columns; slot: of an entry by rows, its place here
  std::vector<double> value;
  void *symbolic = nullptr, *numeric = nullptr;
  bool extracted = false;
  Factors factors;

  Impl() = default;
  ~Impl() {
    umfpack_di_free_numeric(&numeric);
    umfpack_di_free_symbolic(&symbolic);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void extract();
  void solve_one(double* b) const;
  void solve_many(Eigen::MatrixXd& B);
};

void UmfpackSolver::Impl::extract() {
  if (extracted) return;
  Factors& f = factors;
  int l_entries = 0, u_entries = 0, rows = 0, columns = 0, on_diagonal = 0, reciprocal = 0;
  umfpack_di_get_lunz(&l_entries, &u_entries, &rows, &columns, &on_diagonal, numeric);
  f.l_start.resize(n + 1);
  f.u_start.resize(n + 1);
  f.l_col.resize(l_entries);
  f.l.resize(l_entries);
  f.u_row.resize(u_entries);
  f.u.resize(u_entries);
  f.p.resize(n);
  f.q.resize(n);
  f.diagonal.resize(n);
  f.scale.resize(n);
  umfpack_di_get_numeric(f.l_start.data(), f.l_col.data(), f.l.data(), f.u_start.data(), f.u_row.data(),
                         f.u.data(), f.p.data(), f.q.data(), f.diagonal.data(), &reciprocal, f.scale.data(),
                         numeric);
  if (!reciprocal)
    for (double& scale : f.scale) scale = 1 / scale;
  extracted = true;
}

void UmfpackSolver::Impl::solve_one(double* b) const {
  double control[UMFPACK_CONTROL];
  umfpack_di_defaults(control);
  control[UMFPACK_IRSTEP] = 0;
  std::vector<double> x(n);
  umfpack_di_solve(UMFPACK_A, start.data(), index.data(), value.data(), x.data(), b, numeric, control,
                   nullptr);
  std::copy(x.begin(), x.end(), b);
}

// Row by row of the right-hand sides; rows that are still zero cost nothing.
void UmfpackSolver::Impl::solve_many(Eigen::MatrixXd& B) {
  extract();
  const Factors& f = factors;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Y(n, B.cols());
  std::vector<char> zero(n);
  for (int i = 0; i < n; ++i) {
    Y.row(i) = f.scale[f.p[i]] * B.row(f.p[i]);
    bool empty = (Y.row(i).array() == 0).all();
    for (int k = f.l_start[i]; k < f.l_start[i + 1]; ++k) {
      const int j = f.l_col[k];
      if (j == i || zero[j]) continue;
      Y.row(i) -= f.l[k] * Y.row(j);
      empty = false;
    }
    zero[i] = empty;
  }
  for (int j = n - 1; j >= 0; --j) {
    Y.row(j) /= f.diagonal[j];
    for (int k = f.u_start[j]; k < f.u_start[j + 1]; ++k)
      if (f.u_row[k] != j) Y.row(f.u_row[k]) -= f.u[k] * Y.row(j);
  }
  for (int j = 0; j < n; ++j) B.row(f.q[j]) = Y.row(j);
}

UmfpackSolver::UmfpackSolver() : m_impl(std::make_unique<Impl>()) {}
UmfpackSolver::~UmfpackSolver() = default;

void UmfpackSolver::analyze(const SparseView& pattern) {
  Impl& impl = *m_impl;
  umfpack_di_free_numeric(&impl.numeric);
  umfpack_di_free_symbolic(&impl.symbolic);
  impl.n = pattern.n;
  const std::vector<int>& place = impl.slot = places_by_columns(pattern);
  impl.index.resize(place.size());
  impl.value.assign(place.size(), 0);
  impl.start.assign(static_cast<std::size_t>(pattern.n) + 1, 0);
  for (int row = 0; row < pattern.n; ++row)
    for (int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k) {
      impl.index[place[k]] = row;
      ++impl.start[pattern.col[k] + 1];
    }
  for (int c = 0; c < pattern.n; ++c) impl.start[c + 1] += impl.start[c];
}

// The first values help UMFPACK to choose its strategy, the analysis stays valid without them.
bool UmfpackSolver::factorize(const double* value) {
  Impl& impl = *m_impl;
  for (std::size_t k = 0; k < impl.slot.size(); ++k) impl.value[impl.slot[k]] = value[k];
  umfpack_di_free_numeric(&impl.numeric);
  impl.extracted = false;
  int status = UMFPACK_OK;
  if (!impl.symbolic)
    status = umfpack_di_symbolic(impl.n, impl.n, impl.start.data(), impl.index.data(), impl.value.data(),
                                 &impl.symbolic, nullptr, nullptr);
  if (status == UMFPACK_OK)
    status = umfpack_di_numeric(impl.start.data(), impl.index.data(), impl.value.data(), impl.symbolic,
                                &impl.numeric, nullptr, nullptr);
  if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
  return status == UMFPACK_OK; // a singular matrix is a warning
}

void UmfpackSolver::solve(Eigen::MatrixXd& B) {
  if (B.cols() >= MANY) return m_impl->solve_many(B);
  for (Eigen::Index c = 0; c < B.cols(); ++c) m_impl->solve_one(B.col(c).data());
}

} // namespace burnish

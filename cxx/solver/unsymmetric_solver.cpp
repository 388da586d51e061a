#include "solver/unsymmetric_solver.hpp"
#include "base/error.hpp"
#include <new>
#include <string>
#include <suitesparse/umfpack.h>

namespace burnish {

namespace {

void check_status(const char* where, int status) {
  if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
  if (status < 0) throw std::runtime_error(std::string(where) + ": UMFPACK status " + std::to_string(status));
}

} // namespace

/// UMFPACK reads compressed columns: our rows are the columns of A', hence its "transposed" is our "not".
struct UnsymmetricSolver::Impl {
  SparsePattern pattern;
  std::vector<int> start, index, slot; // both triangles, slot: place in the view's values
  std::vector<double> value;
  void* symbolic = nullptr;
  void* numeric = nullptr;
  int analyses = 0;
  double rcond = 0;

  Impl() = default;
  ~Impl() {
    umfpack_di_free_numeric(&numeric);
    umfpack_di_free_symbolic(&symbolic);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void analyze(const SparseView& view);
  void expand();
  Eigen::VectorXd solve(const char* where, int system, const Eigen::VectorXd& b) const;
};

/// Rows of the complete matrix, columns ascending, from one or both triangles.
void UnsymmetricSolver::Impl::expand() {
  std::vector<std::vector<std::pair<int, int>>> rows(pattern.n);
  for (int row = 0; row < pattern.n; ++row) {
    for (int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k) {
      rows[row].emplace_back(pattern.col[k], k);
      if (pattern.symmetric && pattern.col[k] != row) rows[pattern.col[k]].emplace_back(row, k);
    }
  }
  start.assign(1, 0);
  index.clear();
  slot.clear();
  for (const auto& row : rows) {
    // mirrored entries arrive by ascending row, before or after the row's own: already ascending
    for (auto [col, k] : row) {
      index.push_back(col);
      slot.push_back(k);
    }
    start.push_back(static_cast<int>(index.size()));
  }
  value.assign(index.size(), 0.);
}

void UnsymmetricSolver::Impl::analyze(const SparseView& view) {
  const char* where = "UnsymmetricSolver::factorize";
  SparsePattern fresh(where, view);
  check_values(where, view);
  umfpack_di_free_symbolic(&symbolic);
  pattern = std::move(fresh);
  expand();
  for (std::size_t k = 0; k < slot.size(); ++k) value[k] = view.value[slot[k]];
  double control[UMFPACK_CONTROL];
  umfpack_di_defaults(control);
  control[UMFPACK_ORDERING] =
      UMFPACK_ORDERING_CHOLMOD; // AMD, and METIS where that leaves much fill: a third in space
  // values help UMFPACK to choose its strategy, the analysis stays valid without them
  const int status = umfpack_di_symbolic(pattern.n, pattern.n, start.data(), index.data(), value.data(),
                                         &symbolic, control, nullptr);
  if (status < 0) pattern = SparsePattern();
  check_status(where, status);
  ++analyses;
}

Eigen::VectorXd UnsymmetricSolver::Impl::solve(const char* where, int system,
                                               const Eigen::VectorXd& b) const {
  if (!numeric) fail(where, "there is no factor, call factorize first");
  require(b.size() == pattern.n, where, "b.size()", b.size(), "n");
  if (!b.allFinite()) fail(where, "b is not finite, expected finite numbers");
  Eigen::VectorXd x(pattern.n);
  check_status(where, umfpack_di_solve(system, start.data(), index.data(), value.data(), x.data(), b.data(),
                                       numeric, nullptr, nullptr));
  return x;
}

UnsymmetricSolver::UnsymmetricSolver() : m_impl(std::make_unique<Impl>()) {}
UnsymmetricSolver::~UnsymmetricSolver() = default;
UnsymmetricSolver::UnsymmetricSolver(UnsymmetricSolver&&) noexcept = default;
UnsymmetricSolver& UnsymmetricSolver::operator=(UnsymmetricSolver&&) noexcept = default;

FactorStatus UnsymmetricSolver::factorize(const SparseView& matrix) {
  const char* where = "UnsymmetricSolver::factorize";
  Impl& impl = *m_impl;
  umfpack_di_free_numeric(&impl.numeric);
  if (!impl.pattern.matches(matrix)) impl.analyze(matrix);
  check_values(where, matrix);
  for (std::size_t k = 0; k < impl.slot.size(); ++k) impl.value[k] = matrix.value[impl.slot[k]];
  double info[UMFPACK_INFO];
  const int status = umfpack_di_numeric(impl.start.data(), impl.index.data(), impl.value.data(),
                                        impl.symbolic, &impl.numeric, nullptr, info);
  impl.rcond = info[UMFPACK_RCOND];
  if (status == UMFPACK_WARNING_singular_matrix) {
    umfpack_di_free_numeric(&impl.numeric);
    return FactorStatus::SINGULAR;
  }
  check_status(where, status);
  return FactorStatus::OK;
}

Eigen::VectorXd UnsymmetricSolver::solve(const Eigen::VectorXd& b) const {
  return m_impl->solve("UnsymmetricSolver::solve", UMFPACK_Aat, b);
}

Eigen::VectorXd UnsymmetricSolver::solve_transposed(const Eigen::VectorXd& b) const {
  return m_impl->solve("UnsymmetricSolver::solve_transposed", UMFPACK_A, b);
}

double UnsymmetricSolver::rcond() const { return m_impl->rcond; }
int UnsymmetricSolver::analyses() const { return m_impl->analyses; }

} // namespace burnish

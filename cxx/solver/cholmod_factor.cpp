#include "solver/cholmod_factor.hpp"
#include "base/error.hpp"
#include "base/memory_limit.hpp"
#include "solver/cholmod_common.hpp"
#include "solver/openmp_guard.hpp"
#include "solver/required_memory.hpp"
#include <algorithm>
#include <utility>

namespace burnish {

namespace {

constexpr std::size_t LARGE = 2'000'000; // entries of the triangle, from which a factor is worth the care

/// CHOLMOD itself does not look.
void check_lower_triangle(const std::vector<int>& col_start, const std::vector<int>& row) {
  const int n = static_cast<int>(col_start.size()) - 1;
  bool ok = n >= 0 && col_start[0] == 0 && static_cast<std::size_t>(col_start[n]) == row.size();
  for (int j = 0; ok && j < n; ++j) {
    ok = col_start[j] <= col_start[j + 1] && static_cast<std::size_t>(col_start[j + 1]) <= row.size();
    for (int k = col_start[j]; ok && k < col_start[j + 1]; ++k) ok = row[k] >= j && row[k] < n;
  }
  if (!ok) throw std::logic_error("CholmodFactor::analyze: not the columns of a lower triangle");
}

} // namespace

struct CholmodFactor::Impl {
  CholmodCommon common;
  std::vector<int> col_start{0}, row;
  cholmod_factor* factor = nullptr;
  cholmod_dense* solution = nullptr;
  cholmod_dense* work_y = nullptr;
  cholmod_dense* work_e = nullptr;
  bool analyzed = false;
  bool factorized = false;

  Impl() {
    common->supernodal = CHOLMOD_SUPERNODAL;
    common->method[0].ordering = CHOLMOD_NATURAL;
    common->postorder = 0;
    common->final_ll = 1;
    common->quick_return_if_not_posdef = 1;
    // Wider supernodes, with more zeros in them: 0.65 times the time of a factor in the plane (tests/benchmark/bench_solver.cpp).
    common->nrelax[0] = 8;
    common->nrelax[1] = 32;
    common->nrelax[2] = 64;
  }
  ~Impl() {
    free_factor();
    cholmod_free_dense(&solution, common.get());
    cholmod_free_dense(&work_y, common.get());
    cholmod_free_dense(&work_e, common.get());
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  int size() const { return static_cast<int>(col_start.size()) - 1; }
  void free_factor() {
    if (factor) cholmod_free_factor(&factor, common.get());
    factorized = false;
  }
  /// The lower triangle as CHOLMOD sees it, a view of the vectors.
  cholmod_sparse pattern() {
    cholmod_sparse view{};
    view.nrow = view.ncol = size();
    view.nzmax = row.size();
    view.p = col_start.data();
    view.i = row.data();
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_PATTERN;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 0;
    view.packed = 1;
    return view;
  }
  void solve(int system, Eigen::Ref<Eigen::MatrixXd> b);
  void require_factor(const char* where) const {
    if (!factorized)
      throw std::logic_error(std::string(where) + ": there is no factor, call factorize first");
  }
};

CholmodFactor::CholmodFactor() : m_impl(std::make_unique<Impl>()) {}
CholmodFactor::~CholmodFactor() = default;
CholmodFactor::CholmodFactor(CholmodFactor&&) noexcept = default;
CholmodFactor& CholmodFactor::operator=(CholmodFactor&&) noexcept = default;

void CholmodFactor::analyze(std::vector<int> col_start, std::vector<int> row, int /*first*/) {
  check_lower_triangle(col_start, row);
  Impl& impl = *m_impl;
  impl.free_factor();
  impl.analyzed = false;
  impl.col_start = std::move(col_start);
  impl.row = std::move(row);
  if (impl.row.size() > LARGE) return_large_blocks(), take_large_pages();
  if (impl.size() > 0) {
    cholmod_sparse matrix = impl.pattern();
    impl.factor = cholmod_analyze(&matrix, impl.common.get());
    if (!impl.factor) impl.common.check("CholmodFactor::analyze");
    cholmod_free_work(impl.common.get()); // more than the numerical factor needs
    require_memory("CholmodFactor::analyze",
                   "the factor of " + std::to_string(impl.size()) + " unknowns takes",
                   sizeof(double) * static_cast<double>(factor_entries()));
  }
  impl.analyzed = true;
}

FactorStatus CholmodFactor::factorize(std::vector<double> values) {
  Impl& impl = *m_impl;
  if (!impl.analyzed) throw std::logic_error("CholmodFactor::factorize: call analyze first");
  if (values.size() != impl.row.size())
    throw std::logic_error("CholmodFactor::factorize: not as many values as rows of analyze");
  impl.factorized = false;
  if (impl.size() > 0) {
    cholmod_sparse matrix = impl.pattern();
    matrix.xtype = CHOLMOD_REAL;
    matrix.x = values.data();
    const OpenmpGuard guard;
    cholmod_factorize(&matrix, impl.factor, impl.common.get());
    impl.common.check("CholmodFactor::factorize");
    if (impl.common->status == CHOLMOD_NOT_POSDEF || impl.factor->minor < impl.factor->n)
      return FactorStatus::NOT_POSITIVE_DEFINITE;
  }
  impl.factorized = true;
  return FactorStatus::OK;
}

bool CholmodFactor::is_factorized() const { return m_impl->factorized; }

void CholmodFactor::Impl::solve(int system, Eigen::Ref<Eigen::MatrixXd> b) {
  require_factor("CholmodFactor::solve");
  if (b.rows() != size())
    throw std::logic_error("CholmodFactor::solve: b has not as many rows as the matrix");
  if (b.size() == 0) return;
  cholmod_dense right{};
  right.nrow = b.rows();
  right.ncol = b.cols();
  right.d = b.outerStride();
  right.nzmax = right.d * right.ncol;
  right.x = b.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_solve2(system, factor, &right, nullptr, &solution, nullptr, &work_y, &work_e, common.get());
  common.check("CholmodFactor::solve");
  b = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(solution->x), b.rows(), b.cols());
}

void CholmodFactor::solve(Eigen::Ref<Eigen::MatrixXd> b) const { m_impl->solve(CHOLMOD_A, b); }
void CholmodFactor::solve_lower(Eigen::Ref<Eigen::MatrixXd> b) const { m_impl->solve(CHOLMOD_L, b); }
void CholmodFactor::solve_upper(Eigen::Ref<Eigen::MatrixXd> b) const { m_impl->solve(CHOLMOD_Lt, b); }

Eigen::MatrixXd CholmodFactor::trailing_factor(int first) const {
  const Impl& impl = *m_impl;
  impl.require_factor("CholmodFactor::trailing_factor");
  const int n = size();
  if (first < 0 || first > n) throw std::logic_error("CholmodFactor::trailing_factor: first out of range");
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n - first, n - first);
  if (n == 0) return block;
  const Supernodes L = *supernodes();
  for (int s = 0; s < L.count; ++s)
    for (int j = std::max(first, L.first[s]); j < L.first[s + 1]; ++j) {
      const int k = j - L.first[s];
      const double* column = L.panel(s) + static_cast<std::size_t>(k) * L.num_rows(s);
      for (int i = k; i < L.num_rows(s); ++i)
        block(L.rows[L.row_begin[s] + i] - first, j - first) = column[i];
    }
  return block;
}

std::optional<Supernodes> CholmodFactor::supernodes() const {
  m_impl->require_factor("CholmodFactor::supernodes");
  if (size() == 0) return {};
  const cholmod_factor& factor = *m_impl->factor;
  return Supernodes{size(),
                    static_cast<int>(factor.nsuper),
                    static_cast<const int*>(factor.super),
                    static_cast<const int*>(factor.pi),
                    static_cast<const int*>(factor.px),
                    static_cast<const int*>(factor.s),
                    static_cast<const double*>(factor.x)};
}

int CholmodFactor::size() const { return m_impl->size(); }

std::size_t CholmodFactor::factor_entries() const { return m_impl->factor ? m_impl->factor->xsize : 0; }

} // namespace burnish

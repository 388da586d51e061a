#include "base/companion_library.hpp"
#include "base/error.hpp"
#include "base/memory_limit.hpp"
#include "solver/cholmod_factor.hpp"
#include "solver/fill_ordering.hpp"
#include "solver/openmp_guard.hpp"
#include "unit/solver/sparse_sample.hpp"
#include <atomic>
#include <dlfcn.h>
#include <gtest/gtest.h>

using namespace burnish;

namespace {

/// Lower triangle by columns (the rows of the upper one) of a symmetric matrix. @returns its values
std::vector<double> load(CholmodFactor& factor, const Eigen::MatrixXd& full) {
  const sample::Sparse upper = sample::sparse(full, [](int i, int j) { return i <= j; });
  factor.analyze(upper.row_start, upper.col);
  return upper.value;
}

Graph graph_of(const Eigen::MatrixXd& full) {
  const sample::Sparse matrix = sample::sparse(full);
  return {matrix.row_start, matrix.col};
}

bool is_permutation(std::vector<int> order, int n) {
  std::sort(order.begin(), order.end());
  for (int k = 0; k < n; ++k)
    if (static_cast<int>(order.size()) != n || order[k] != k) return false;
  return true;
}

} // namespace

TEST(CholmodFactor, FactorAndSolutionsEqualDense) {
  const Eigen::MatrixXd full = sample::symmetric_matrix();
  const int n = static_cast<int>(full.rows());
  CholmodFactor factor;
  ASSERT_EQ(factor.factorize(load(factor, full)), FactorStatus::OK);
  const Eigen::MatrixXd L = full.llt().matrixL();
  for (int first : {0, n / 2, n - 1, n}) {
    const Eigen::MatrixXd block = factor.trailing_factor(first);
    ASSERT_EQ(block.rows(), n - first);
    if (first == n) continue;
    EXPECT_LT((block - L.bottomRightCorner(n - first, n - first)).norm(), 1e-12 * L.norm()) << first;
  }
  Eigen::MatrixXd b = Eigen::MatrixXd::Random(n + 2, 7), x = b;
  factor.solve(x.middleRows(1, n)); // part of a larger array, more than one column
  EXPECT_LT((full * x.middleRows(1, n) - b.middleRows(1, n)).norm(), 1e-12 * b.norm());
  EXPECT_EQ(x.row(0), b.row(0));
  EXPECT_EQ(x.row(n + 1), b.row(n + 1));
  EXPECT_GE(factor.factor_entries(), static_cast<std::size_t>((L.array() != 0.).count()));
}

TEST(CholmodFactor, EmptyMatrix) {
  CholmodFactor factor;
  factor.analyze({0}, {});
  EXPECT_EQ(factor.factorize({}), FactorStatus::OK);
  Eigen::MatrixXd b(0, 1);
  EXPECT_NO_THROW(factor.solve(b));
  EXPECT_EQ(factor.trailing_factor(0).size(), 0);
}

TEST(CholmodFactor, MissingDiagonalIsNotPositiveDefinite) {
  CholmodFactor factor;
  factor.analyze({0, 2, 2}, {0, 1});
  EXPECT_EQ(factor.factorize({2., 1.}), FactorStatus::NOT_POSITIVE_DEFINITE);
  EXPECT_FALSE(factor.is_factorized());
}

TEST(CholmodFactor, RefusesCallsOutOfOrder) {
  CholmodFactor factor;
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(3, 1);
  EXPECT_THROW(factor.factorize({}), std::logic_error);
  const std::vector<double> values = load(factor, Eigen::MatrixXd::Identity(4, 4));
  EXPECT_THROW(factor.factorize({1., 1., 1.}), std::logic_error); // 3 values of 4
  EXPECT_THROW(factor.solve(b), std::logic_error);
  EXPECT_THROW(factor.trailing_factor(0), std::logic_error);
  ASSERT_EQ(factor.factorize(values), FactorStatus::OK);
  EXPECT_THROW(factor.solve(b), std::logic_error); // 3 rows of 4
  EXPECT_THROW(factor.trailing_factor(5), std::logic_error);
  EXPECT_THROW(factor.trailing_factor(-1), std::logic_error);
}

TEST(CholmodFactor, RefusesWhatIsNoLowerTriangle) {
  CholmodFactor factor;
  EXPECT_NO_THROW(factor.analyze({0, 2, 3}, {1, 0, 1}));
  EXPECT_THROW(factor.analyze({}, {}), std::logic_error);
  EXPECT_THROW(factor.analyze({0, 1}, {1}), std::logic_error);       // row out of range
  EXPECT_THROW(factor.analyze({0, 1, 2}, {0, 0}), std::logic_error); // above the diagonal
  EXPECT_THROW(factor.analyze({0, 1}, {0, 0}), std::logic_error);    // rows of no column
  EXPECT_THROW(factor.analyze({1, 1}, {0}), std::logic_error);       // does not start at 0
  EXPECT_THROW(factor.analyze({0, 3, 2}, {0, 1}), std::logic_error); // descending
}

TEST(FillOrdering, BothMethodsSaveFill) {
  const Eigen::MatrixXd full = sample::symmetric_matrix(6, 12);
  const int n = static_cast<int>(full.rows());
  const auto entries = [&](const std::vector<int>& order) {
    CholmodFactor factor;
    load(factor, full(order, order));
    return factor.factor_entries();
  };
  std::vector<int> shuffled(n);
  for (int k = 0; k < n; ++k) shuffled[k] = k;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(2));
  for (Ordering ordering : {Ordering::AMD, Ordering::METIS}) {
    const std::vector<int> order = fill_reducing_order(graph_of(full), ordering);
    ASSERT_TRUE(is_permutation(order, n));
    EXPECT_LT(3 * entries(order), entries(shuffled)) << "method " << int(ordering);
  }
}

TEST(FillOrdering, EdgesMayBeListedOnceAndGraphsMayBeTrivial) {
  const Eigen::MatrixXd full = sample::symmetric_matrix(2, 3);
  const sample::Sparse lower = sample::sparse(full, [](int i, int j) { return i > j; });
  EXPECT_EQ(fill_reducing_order({lower.row_start, lower.col}, Ordering::AMD),
            fill_reducing_order(graph_of(full), Ordering::AMD));
  for (Ordering ordering : {Ordering::AMD, Ordering::METIS}) {
    EXPECT_TRUE(fill_reducing_order(Graph(), ordering).empty());
    EXPECT_EQ(fill_reducing_order({{0, 0}, {}}, ordering), std::vector<int>{0});
    EXPECT_TRUE(is_permutation(fill_reducing_order({{0, 0, 0, 0}, {}}, ordering), 3));
  }
  EXPECT_THROW(fill_reducing_order({{0, 1}, {1}}, Ordering::AMD), std::runtime_error);
}

TEST(OpenmpGuard, LimitsAndRestoresTheNestingLevels) {
  auto* levels = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
  auto* parallel = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_parallel"));
  const bool guarded = levels && !(parallel && parallel() == 2); // OpenBLAS on OpenMP keeps its threads
  const int before = levels ? levels() : -1;
  {
    const OpenmpGuard guard;
    EXPECT_EQ(levels ? levels() : -1, guarded ? 0 : before);
  }
  EXPECT_EQ(levels ? levels() : -1, before);
  EXPECT_NE(before, 0);
}

// burnish_openmp.so: a region is a plain call while a guard wants it, one of OpenMP's run time else.
TEST(OpenmpGuard, SerialRegionsAreCallsOfTheSameThread) {
  void* library = open_companion("burnish_openmp.so", "serial regions", "libgomp1");
  const auto wanted = reinterpret_cast<decltype(&burnish_serial_regions)>(
      companion_function(library, "burnish_openmp.so", "burnish_serial_regions"));
  const auto parallel = reinterpret_cast<void (*)(void (*)(void*), void*, unsigned, unsigned)>(
      companion_function(library, "burnish_openmp.so", "GOMP_parallel"));
  std::atomic<int> calls{0};
  const auto region = [](void* data) { ++*static_cast<std::atomic<int>*>(data); };
  EXPECT_FALSE(wanted(true));
  parallel(region, &calls, 3, 0);
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(wanted(false));
  parallel(region, &calls, 3, 0);
  EXPECT_EQ(calls, 4);
}

// Full triangle of 2000: 32 MB of factor where 28 MB are left.
TEST(CholmodFactor, OneThatDoesNotFitIsRefusedBeforeItIsMade) {
  const int n = 2000;
  std::vector<int> col_start{0}, row;
  for (int j = 0; j < n; ++j) {
    for (int i = j; i < n; ++i) row.push_back(i);
    col_start.push_back(static_cast<int>(row.size()));
  }
  CholmodFactor factor;
  EXPECT_GT(memory_left(), 1e8);
  try {
    const MemoryLimit limit(28e6);
    factor.analyze(col_start, row);
    FAIL() << "analyzed";
  } catch (const ArgumentError& e) {
    EXPECT_NE(e.said().find("the factor of 2000 unknowns takes 0.03 GB"), std::string::npos) << e.what();
  }
  factor.analyze(col_start, row);
  EXPECT_EQ(factor.factor_entries(), 4000000u);
}

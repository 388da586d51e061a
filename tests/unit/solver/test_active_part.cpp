// The dense factor whose selection changes: solutions, updates counted, refused parts, copies.
#include "solver/active_part.hpp"
#include "unit/finite_difference.hpp"
#include <algorithm>
#include <numeric>
#include <random>

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr int SIZE = 90;
using Indices = std::vector<int>;

/// Symmetric positive definite, eigenvalues 1 .. 1e4.
std::shared_ptr<const Eigen::MatrixXd> sample(unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(SIZE, SIZE, [&] { return normal(random); });
  const Eigen::MatrixXd Q = Eigen::HouseholderQR<Eigen::MatrixXd>(A).householderQ();
  const Eigen::VectorXd values = Eigen::ArrayXd::LinSpaced(SIZE, 0, std::log(1e4)).exp();
  const Eigen::MatrixXd C = Q * values.asDiagonal() * Q.transpose();
  return std::make_shared<Eigen::MatrixXd>(0.5 * (C + C.transpose()));
}

Indices first(int n) {
  Indices list(n);
  std::iota(list.begin(), list.end(), 0);
  return list;
}

/// The current part against a fresh dense factor, two right-hand sides.
void check_solutions(const ActivePart& factor, const Indices& selected) {
  const auto n = static_cast<Eigen::Index>(selected.size());
  Eigen::MatrixXd part(n, n), B(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    B.row(i) << std::cos(selected[i] + 0.3), 1;
    for (Eigen::Index j = 0; j < n; ++j) part(i, j) = factor.entry(selected[i], selected[j]);
  }
  const Eigen::MatrixXd expected = part.llt().solve(B);
  expect_close(factor.solve(B), expected, expected.norm(), 1e-11, "C^-1 B");
}

/// What a contact does to its active nodes: some come, some leave, the order changes, or nothing happens.
Indices changed(Indices selected, std::mt19937& random) {
  const auto any = [&](std::size_t n) { return static_cast<std::ptrdiff_t>(random() % n); };
  const auto kind = any(5), few = 1 + any(4);
  if (kind == 0) std::shuffle(selected.begin(), selected.end(), random);
  for (std::ptrdiff_t k = 0; k < few && (kind == 1 || kind == 2); ++k)
    if (selected.size() > 45) selected.erase(selected.begin() + any(selected.size()));
  for (std::ptrdiff_t k = 0; k < few && (kind == 2 || kind == 3); ++k) {
    int fresh = static_cast<int>(any(SIZE));
    while (std::find(selected.begin(), selected.end(), fresh) != selected.end()) fresh = (fresh + 1) % SIZE;
    if (selected.size() < 75) selected.insert(selected.begin() + any(selected.size() + 1), fresh);
  }
  return selected;
}

TEST(ActivePart, ManyColumnsComeByTheInverseWhichFollowsTheSelection) {
  constexpr int n = 700;
  auto matrix = std::make_shared<Eigen::MatrixXd>(
      Eigen::MatrixXd::NullaryExpr(n, n, [](Eigen::Index i, Eigen::Index j) {
        return std::exp(-0.05 * static_cast<double>(std::abs(i - j))) + (i == j ? 1 : 0);
      }));
  ActivePart part;
  part.set(matrix);
  Indices selected = first(n);
  for (const int gone : {0, 2, 300}) { // anew, by updates, anew
    selected.erase(selected.begin(), selected.begin() + gone);
    std::reverse(selected.begin(), selected.end()); // the order of the factor is another one
    ASSERT_TRUE(part.select(selected));
    const auto size = static_cast<Eigen::Index>(selected.size());
    const Eigen::MatrixXd B = Eigen::MatrixXd::Identity(size, size / 2);
    EXPECT_LT(((*matrix)(selected, selected) * part.solve(B) - B).norm(), 1e-11 * B.norm());
    EXPECT_LT((part.solve(B).leftCols(3) - part.solve(B.leftCols(3))).norm(), 1e-12);
  }
  EXPECT_GT(part.updates(), 0);
}

TEST(ActivePart, PartsOfAnUnsymmetricMatrixThatIsKnownInParts) {
  const Eigen::MatrixXd whole = Eigen::MatrixXd::Random(9, 9) + 9 * Eigen::MatrixXd::Identity(9, 9);
  auto matrix = std::make_shared<Eigen::MatrixXd>();
  Indices known;
  ActivePart part;
  part.set(matrix, false,
           {[&](const Indices& indices) {
              Indices places;
              for (const int i : indices) {
                if (std::find(known.begin(), known.end(), i) == known.end()) known.push_back(i);
                places.push_back(static_cast<int>(std::find(known.begin(), known.end(), i) - known.begin()));
              }
              *matrix = whole(known, known);
              return places;
            },
            [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return whole * x; }});
  for (const std::vector<int>& selected : {std::vector<int>{1, 4, 5}, {5, 1}, {0, 2, 3, 8}}) {
    ASSERT_TRUE(part.select(selected));
    const Eigen::MatrixXd B = Eigen::MatrixXd::Random(static_cast<Eigen::Index>(selected.size()), 2);
    EXPECT_LT((whole(selected, selected) * part.solve(B) - B).norm(), 1e-12 * B.norm());
  }
  EXPECT_EQ(matrix->rows(), 7);
  EXPECT_EQ(part.entry(8, 2), whole(8, 2));
  EXPECT_EQ(part.entry(8, 1), 0);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(9), y = Eigen::VectorXd::Ones(9);
  x[3] = 2;
  part.add_product(x, y);
  EXPECT_LT((y - Eigen::VectorXd::Ones(9) - 2 * whole.col(3)).norm(), 1e-14);
}

} // namespace

TEST(ActivePart, AgainstAFreshFactorThroughRandomSelections) {
  for (const int updates_from : {0, 55, 1000}) {
    SCOPED_TRACE("updates from " + std::to_string(updates_from));
    std::mt19937 random(7);
    ActivePart factor(updates_from);
    factor.set(sample());
    Indices selected = first(60);
    for (int step = 0; step < 400; ++step) {
      ASSERT_TRUE(factor.select(selected));
      check_solutions(factor, selected);
      if (testing::Test::HasFailure()) FAIL() << "after step " << step;
      selected = changed(selected, random);
    }
    if (updates_from > SIZE)
      EXPECT_EQ(factor.updates(), 0);
    else
      EXPECT_GE(factor.updates(), 50) << "the sequence is one of updates";
    if (updates_from == 0)
      EXPECT_LE(factor.factorizations(), 20);
    else
      EXPECT_GE(factor.factorizations(), 50);
  }
}

// One factorization in all: rows that go and come are counted, the rest is free.
TEST(ActivePart, FewChangesAreUpdatesAndNoFactorization) {
  ActivePart factor(0);
  factor.set(sample());
  Indices selected = first(60);
  const auto expect_counts = [&](long updates) {
    ASSERT_TRUE(factor.select(selected));
    EXPECT_EQ(factor.factorizations(), 1);
    EXPECT_EQ(factor.updates(), updates);
    check_solutions(factor, selected);
  };
  expect_counts(0);
  expect_counts(0); // the same
  selected.insert(selected.begin() + 5, {61, 60, 75});
  expect_counts(3);
  selected.erase(selected.begin() + 10, selected.begin() + 14);
  expect_counts(7);
  selected.erase(selected.begin());
  selected.push_back(80);
  expect_counts(9);
  std::reverse(selected.begin(), selected.end());
  expect_counts(9);
}

// More than a sixth of the rows change: a new factor is cheaper.
TEST(ActivePart, ManyChangesAreANewFactorization) {
  ActivePart factor(0);
  factor.set(sample());
  ASSERT_TRUE(factor.select(first(50)));
  ASSERT_TRUE(factor.select(first(60))); // 10 of 60
  EXPECT_EQ(factor.factorizations(), 1);
  EXPECT_EQ(factor.updates(), 10);
  ASSERT_TRUE(factor.select(first(73))); // 13 of 73
  EXPECT_EQ(factor.factorizations(), 2);
  EXPECT_EQ(factor.updates(), 10);
  check_solutions(factor, first(73));
  const Indices other{80, 81, 3};
  ASSERT_TRUE(factor.select(other));
  EXPECT_EQ(factor.factorizations(), 3);
  check_solutions(factor, other);
}

TEST(ActivePart, UpdatesFromASize) {
  ActivePart factor(20);
  factor.set(sample());
  for (int n = 15; n <= 25; ++n) ASSERT_TRUE(factor.select(first(n)));
  EXPECT_EQ(factor.factorizations(), 6) << "15 .. 20";
  EXPECT_EQ(factor.updates(), 5) << "from 20 rows to 21 .. 25";
  ASSERT_TRUE(factor.select(first(19))); // six of 19 rows
  EXPECT_EQ(factor.factorizations(), 7);
  ActivePart by_default;
  by_default.set(sample());
  for (int n = 80; n <= SIZE; ++n) ASSERT_TRUE(by_default.select(first(n)));
  EXPECT_EQ(by_default.updates(), 0) << "from 400 rows on";
  check_solutions(by_default, first(SIZE));
}

TEST(ActivePart, NothingSelected) {
  ActivePart factor(0);
  factor.set(sample());
  ASSERT_TRUE(factor.select({}));
  EXPECT_EQ(factor.solve(Eigen::MatrixXd(0, 3)).cols(), 3);
  ASSERT_TRUE(factor.select(first(8)));
  check_solutions(factor, first(8));
  ASSERT_TRUE(factor.select({}));
  ASSERT_TRUE(factor.select({4}));
  check_solutions(factor, {4});
}

// Row 30 makes every part that holds it indefinite.
TEST(ActivePart, RefusesAPartThatIsNotPositiveDefiniteAndRecovers) {
  auto matrix = std::make_shared<Eigen::MatrixXd>(*sample());
  (*matrix)(30, 30) = -1;
  for (const int updates_from : {0, 1000}) {
    ActivePart factor(updates_from);
    factor.set(matrix);
    ASSERT_TRUE(factor.select(first(30)));
    for (int again = 0; again < 2; ++again) {
      EXPECT_FALSE(factor.select(first(31)));
      EXPECT_FALSE(factor.select(first(31))) << "the same once more";
      ASSERT_TRUE(factor.select(first(30)));
      check_solutions(factor, first(30));
    }
    Indices without = first(36);
    without.erase(without.begin() + 30);
    ASSERT_TRUE(factor.select(without));
    check_solutions(factor, without);
    EXPECT_FALSE(factor.select({30}));
    ASSERT_TRUE(factor.select(without));
    check_solutions(factor, without);
  }
}

TEST(ActivePart, CopiesAreIndependent) {
  ActivePart factor(0);
  factor.set(sample());
  ASSERT_TRUE(factor.select(first(40)));
  ActivePart copy = factor;
  ASSERT_TRUE(copy.select(first(44)));
  EXPECT_EQ(copy.factorizations(), 1) << "it goes on from the factor that was copied";
  EXPECT_EQ(factor.updates(), 0);
  Indices fewer = first(40);
  fewer.erase(fewer.begin() + 7);
  ASSERT_TRUE(factor.select(fewer));
  check_solutions(copy, first(44));
  check_solutions(factor, fewer);
  copy.set(sample(2));
  ASSERT_TRUE(copy.select(first(5)));
  check_solutions(copy, first(5));
  check_solutions(factor, fewer);
  factor = copy;
  check_solutions(factor, first(5));
}

TEST(ActivePart, AnotherMatrixForgetsTheFactor) {
  ActivePart factor(0);
  factor.set(sample());
  ASSERT_TRUE(factor.select(first(40)));
  factor.set(sample(2));
  ASSERT_TRUE(factor.select(first(40)));
  EXPECT_EQ(factor.factorizations(), 2);
  check_solutions(factor, first(40));
}

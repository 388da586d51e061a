#include "solver/node_block_matrix.hpp"
#include "unit/solver/elastic_sample.hpp"
#include <gtest/gtest.h>
#include <limits>
#include <string>

using namespace burnish;

namespace {

struct Triplets {
  std::vector<int> row, col;
  std::vector<double> value;
  void add(int i, int j, double v) {
    row.push_back(i);
    col.push_back(j);
    value.push_back(v);
  }
  TripletView view(int n, bool half = false) const {
    return {n, row.size(), row.data(), col.data(), value.data(), half};
  }
};

enum class Part { FULL, LOWER, UPPER };

/// Every stored entry of the part, in a shuffled order.
template <int Dim> Triplets shuffled(const NodeBlockMatrix<Dim>& matrix, Part part) {
  Triplets ordered, result;
  for (int node = 0; node < matrix.num_nodes; ++node)
    for (int k = matrix.row_start[node]; k < matrix.row_start[node + 1]; ++k)
      for (int e = 0; e < Dim * Dim; ++e) {
        const int i = Dim * node + e / Dim, j = Dim * matrix.col[k] + e % Dim;
        if ((part == Part::LOWER && i < j) || (part == Part::UPPER && i > j)) continue;
        ordered.add(i, j, matrix.block(k)[e]);
      }
  std::vector<std::size_t> order(ordered.row.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  for (std::size_t k : order) result.add(ordered.row[k], ordered.col[k], ordered.value[k]);
  return result;
}

std::string message_of(const Triplets& triplets, int n, bool half = false) {
  try {
    TripletReader<2>().read(triplets.view(n, half));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no exception";
}

} // namespace

TEST(NodeBlockMatrix, PatternOfTwoTriangles) {
  // nodes 0 1 2 and 1 2 3; node 4 belongs to no element
  const NodeBlockMatrix<2> matrix = pattern_from_elements<2>(5, 3, {0, 1, 2, 1, 3, 2});
  EXPECT_EQ(matrix.row_start, (std::vector<int>{0, 3, 7, 11, 14, 15}));
  EXPECT_EQ(matrix.col, (std::vector<int>{0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 3, 1, 2, 3, 4}));
  EXPECT_EQ(matrix.value, std::vector<double>(15 * 4, 0.));
  EXPECT_EQ(matrix.size(), 10);
  EXPECT_EQ(matrix.find(1, 3), 6);
  EXPECT_EQ(matrix.find(0, 3), -1);
  EXPECT_EQ(matrix.find(5, 0), -1);
  EXPECT_EQ(matrix.find(-1, 0), -1);
}

TEST(NodeBlockMatrix, PatternRefusesBadInput) {
  EXPECT_THROW(pattern_from_elements<2>(0, 3, {}), std::invalid_argument);
  EXPECT_THROW(pattern_from_elements<2>(3, 0, {}), std::invalid_argument);
  EXPECT_THROW(pattern_from_elements<2>(3, 3, {0, 1}), std::invalid_argument);
  EXPECT_THROW(pattern_from_elements<2>(3, 3, {0, 1, 3}), std::invalid_argument);
  EXPECT_THROW(pattern_from_elements<3>(3, 3, {0, -1, 2}), std::invalid_argument);
}

TEST(NodeBlockMatrix, MultiplyEqualsDense) {
  const NodeBlockMatrix<2> plane = sample::stiffness(sample::with_mid_nodes(sample::ring_sector(3, 4)), 0.1);
  const Eigen::VectorXd x = sample::random_vector(plane.size());
  EXPECT_LT((plane.multiply(x) - sample::dense(plane) * x).norm(), 1e-13 * x.norm());
  const NodeBlockMatrix<3> space = sample::stiffness(sample::cube(2), 0.1);
  const Eigen::VectorXd y = sample::random_vector(space.size());
  EXPECT_LT((space.multiply(y) - sample::dense(space) * y).norm(), 1e-13 * y.norm());
  EXPECT_THROW(plane.multiply(y), std::invalid_argument);
}

template <class T> class TripletParts : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(TripletParts, Dimensions);

TYPED_TEST(TripletParts, FullAndBothHalvesInAnyOrderGiveTheMatrix) {
  constexpr int DIM = TypeParam::value;
  NodeBlockMatrix<DIM> matrix;
  if constexpr (DIM == 2) matrix = sample::stiffness(sample::ring_sector(3, 5), 0.2);
  if constexpr (DIM == 3) matrix = sample::stiffness(sample::cube(2), 0.2);
  const Eigen::MatrixXd expected = sample::dense(matrix);
  for (Part part : {Part::FULL, Part::LOWER, Part::UPPER}) {
    TripletReader<DIM> reader;
    const Triplets triplets = shuffled(matrix, part);
    const NodeBlockMatrix<DIM>& result = reader.read(triplets.view(matrix.size(), part != Part::FULL));
    EXPECT_EQ(result.row_start, matrix.row_start);
    EXPECT_EQ(result.col, matrix.col);
    // the sample is symmetric within rounding only, a half matrix exactly
    EXPECT_LT((sample::dense(result) - expected).cwiseAbs().maxCoeff(), 1e-14) << "part " << int(part);
  }
}

TEST(TripletReader, KeepsNonsymmetricValuesAndSymmetrizesThePattern) {
  Triplets triplets;
  triplets.add(0, 5, 2.);
  triplets.add(0, 5, 0.5); // repeated: added
  triplets.add(3, 3, 7.);
  TripletReader<2> reader;
  const NodeBlockMatrix<2>& matrix = reader.read(triplets.view(6));
  EXPECT_EQ(matrix.row_start, (std::vector<int>{0, 2, 3, 5}));
  EXPECT_EQ(matrix.col, (std::vector<int>{0, 2, 1, 0, 2}));
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(6, 6);
  expected(0, 5) = 2.5;
  expected(3, 3) = 7.;
  EXPECT_EQ(sample::dense(matrix), expected);
}

TEST(TripletReader, ReusesSlotsForNewValuesAndRebuildsForNewIndices) {
  Triplets triplets;
  triplets.add(0, 0, 1.);
  triplets.add(1, 0, 2.);
  triplets.add(3, 2, 3.);
  TripletReader<2> reader;
  reader.read(triplets.view(4));
  triplets.value = {4., 5., 6.};
  EXPECT_EQ(sample::dense(reader.read(triplets.view(4)))(1, 0), 5.);
  EXPECT_EQ(reader.builds(), 1);
  EXPECT_EQ(sample::dense(reader.read(triplets.view(4, true)))(0, 1), 5.); // half: mirrored
  EXPECT_EQ(reader.builds(), 2);
  triplets.col[2] = 0; // another place, the same number of triplets
  const Eigen::MatrixXd moved = sample::dense(reader.read(triplets.view(4, true)));
  EXPECT_EQ(reader.builds(), 3);
  EXPECT_EQ(moved(3, 0), 6.);
  EXPECT_EQ(moved(0, 3), 6.);
  EXPECT_EQ(moved(3, 2), 0.);
  reader.read(triplets.view(6, true)); // more unknowns
  EXPECT_EQ(reader.builds(), 4);
  triplets.row[0] = triplets.col[0] = 1;
  EXPECT_EQ(sample::dense(reader.read(triplets.view(6, true)))(1, 1), 4.);
  EXPECT_EQ(reader.builds(), 5);
}

TEST(TripletReader, RefusesValuesThatAreNotFiniteWithTheirPlace) {
  Triplets triplets;
  triplets.add(0, 0, 1.);
  triplets.add(2, 3, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(message_of(triplets, 4),
            "TripletReader::read: value of entry (row 2, column 3) = nan, expected a finite number");
  triplets.value[1] = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(message_of(triplets, 4),
            "TripletReader::read: value of entry (row 2, column 3) = -inf, expected a finite number");
}

TEST(TripletReader, ExceptionLeavesTheMatrixUnchanged) {
  Triplets triplets;
  triplets.add(0, 0, 1.);
  TripletReader<2> reader;
  const NodeBlockMatrix<2>& matrix = reader.read(triplets.view(2));
  triplets.value[0] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(reader.read(triplets.view(2)), std::invalid_argument);
  EXPECT_THROW(reader.read(triplets.view(4)), std::invalid_argument);
  EXPECT_EQ(matrix.num_nodes, 1);
  EXPECT_EQ(matrix.value[0], 1.);
}

TEST(TripletReader, RefusesBadIndices) {
  Triplets triplets;
  triplets.add(0, 4, 1.);
  EXPECT_NE(message_of(triplets, 4).find("col = 4, expected 0 <= col < n"), std::string::npos);
  triplets.row[0] = -1;
  EXPECT_NE(message_of(triplets, 4).find("row = -1, expected 0 <= row < n"), std::string::npos);
  EXPECT_NE(message_of(triplets, 5).find("n = 5, expected a positive multiple of 2"), std::string::npos);
  EXPECT_NE(message_of(triplets, 0).find("n = 0"), std::string::npos);
  EXPECT_THROW(TripletReader<3>().read({4, 0, nullptr, nullptr, nullptr, false}), std::invalid_argument);
  EXPECT_THROW(TripletReader<2>().read({4, 1, nullptr, nullptr, nullptr, false}), std::invalid_argument);
}

TEST(TripletReader, RefusesBothTrianglesOfAHalfMatrix) {
  Triplets triplets;
  triplets.add(1, 0, 1.);
  triplets.add(2, 2, 1.);
  triplets.add(0, 1, 1.);
  EXPECT_NE(message_of(triplets, 4, true).find("entry (0, 1) is in the other triangle"), std::string::npos);
  EXPECT_EQ(message_of(triplets, 4, false), "no exception");
}

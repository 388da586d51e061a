// Integrals over triangles of space: flat ones by closed forms, a curved one against the area of many flat pieces.
#include "mesh/facet_measure.hpp"
#include "mesh/simplex.hpp"
#include <gtest/gtest.h>

using namespace burnish;

namespace {

const std::vector<Vector<3>> CORNERS = {{0.1, 0.2, 0.3}, {1.4, 0.1, 0.7}, {0.4, 1.3, -0.2}};

std::vector<Vector<3>> with_middles() {
  std::vector<Vector<3>> x = CORNERS;
  for (const auto& [a, b] : SimplexEdges<2>::ends) x.push_back(0.5 * (x[a] + x[b]));
  return x;
}
double flat_area(const Vector<3>& a, const Vector<3>& b, const Vector<3>& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}

/// Integrals of N_i phi_j by n^2 flat pieces, each by the midpoint rule.
Eigen::MatrixXd summed(const std::vector<Vector<3>>& x, int n) {
  const int nodes = static_cast<int>(x.size());
  const auto values = [&](const Barycentric<2>& l) {
    Eigen::VectorXd N(nodes);
    shape_functions<2>(nodes, l, N.data());
    return N;
  };
  const auto place = [&](const Barycentric<2>& l) {
    const Eigen::VectorXd N = values(l);
    Vector<3> at = Vector<3>::Zero();
    for (int a = 0; a < nodes; ++a) at += N[a] * x[a];
    return at;
  };
  const auto grid = [n](int i, int j) -> Barycentric<2> { return Vector<3>(n - i - j, i, j) / n; };
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(nodes, 3);
  const auto add = [&](const Barycentric<2>& a, const Barycentric<2>& b, const Barycentric<2>& c) {
    const Barycentric<2> middle = (a + b + c) / 3;
    sum += flat_area(place(a), place(b), place(c)) * values(middle) * middle.transpose();
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      add(grid(i, j), grid(i + 1, j), grid(i, j + 1));
      if (i + j < n - 1) add(grid(i + 1, j), grid(i + 1, j + 1), grid(i, j + 1));
    }
  return sum;
}

} // namespace

// T3: A/12 (1 + delta). T6: integrals of l_a (2 l_a - 1) l_j and 4 l_a l_b l_j; the corners' sum is 0, a mid node's A/3.
TEST(FaceMeasure, FlatTriangles) {
  const double area = flat_area(CORNERS[0], CORNERS[1], CORNERS[2]);
  const Eigen::MatrixXd linear = FaceMeasure().masses(CORNERS),
                        quadratic = FaceMeasure().masses(with_middles());
  ASSERT_EQ(quadratic.rows(), 6);
  for (int j = 0; j < 3; ++j)
    for (int a = 0; a < 3; ++a) {
      EXPECT_NEAR(linear(a, j), area / 12 * (a == j ? 2 : 1), 1e-15);
      EXPECT_NEAR(quadratic(a, j), area / 60 * (a == j ? 2 : -1), 1e-15);
      EXPECT_NEAR(quadratic(3 + a, j), area / 15 * (a == j ? 1 : 2), 1e-15);
    }
  for (int a = 0; a < 3; ++a) {
    EXPECT_NEAR(quadratic.row(a).sum(), 0, 1e-15);
    EXPECT_NEAR(quadratic.row(3 + a).sum(), area / 3, 1e-15);
  }
}

// Mid nodes off the plane by a twentieth of an edge: the flat pieces come closer by their number squared, and Richardson's
// step leaves less than the rule's error, 7e-6 of the area.
TEST(FaceMeasure, CurvedTriangle) {
  std::vector<Vector<3>> x = with_middles();
  const Vector<3> up = 0.06 * (x[1] - x[0]).cross(x[2] - x[0]).normalized();
  x[3] += up + 0.03 * (x[2] - x[1]);
  x[4] -= 0.5 * up;
  x[5] += 1.2 * up;
  const Eigen::MatrixXd coarse = summed(x, 100), fine = summed(x, 200), sum = (4 * fine - coarse) / 3;
  const Eigen::MatrixXd ours = FaceMeasure().masses(x);
  EXPECT_LE((ours - sum).cwiseAbs().maxCoeff(), 2e-5 * sum.sum());
  EXPECT_GE(std::abs(sum.sum() - FaceMeasure().masses(with_middles()).sum()), 1e-3) << "curved enough";
}

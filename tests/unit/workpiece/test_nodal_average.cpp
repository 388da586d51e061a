// Quadrature-point fields at the nodes: linear fields exactly, others within the range of the neighboring
// points.
#include "unit/finite_difference.hpp"
#include "unit/workpiece/patch.hpp"
#include "workpiece/nodal_average.hpp"
#include <cmath>

using namespace burnish;
using namespace burnish::test;

namespace {

Eigen::VectorXd at_points(const Discretization<2>& d, double (*field)(double, double)) {
  Eigen::VectorXd values(d.num_points());
  for (int p = 0; p < d.num_points(); ++p) values[p] = field(d.point[2 * p], d.point[2 * p + 1]);
  return values;
}

} // namespace

TEST(NodalAverage, LinearFieldInsideIsExact) {
  for (const int per_element : {3, 6}) {
    const auto d = patch(per_element, 1.0);
    const auto field = [](double x, double y) { return 2 + 3 * x - 5 * y; };
    const Eigen::VectorXd values = at_points(d, field), nodal = nodal_average(d, values);
    const double low = values.minCoeff(), high = values.maxCoeff();
    int exact = 0;
    for (int a = 0; a < d.num_nodes; ++a) {
      EXPECT_GE(nodal[a], low);
      EXPECT_LE(nodal[a], high);
      exact += std::abs(nodal[a] - field(d.node(a)[0], d.node(a)[1])) < 1e-12;
    }
    EXPECT_GE(exact, per_element == 3 ? 1 : 4); // nodes inside, where the range of the points does not bind
  }
}

TEST(NodalAverage, ConstantFieldIsExactAndUnitsDoNotMatter) {
  const auto d = patch(6, 1.0), in_mm = patch(6, 1e3);
  const auto bump = [](double x, double y) { return std::exp(-x * x - 2 * y); };
  EXPECT_LT((nodal_average(d, Eigen::VectorXd::Constant(d.num_points(), 7.5)).array() - 7.5).abs().maxCoeff(),
            1e-13);
  const Eigen::VectorXd values = at_points(d, bump);
  EXPECT_LT((nodal_average(d, values) - nodal_average(in_mm, values)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(NodalAverage, WrongSizeIsRefused) {
  expect_invalid([] { nodal_average(patch(3, 1.0), Eigen::VectorXd::Zero(1)); },
                 "nodal_average: number of values = 1");
}

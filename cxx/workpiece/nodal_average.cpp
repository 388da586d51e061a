#include "workpiece/nodal_average.hpp"
#include "base/error.hpp"
#include <algorithm>

namespace burnish {
namespace {

// Elements of every node.
std::vector<std::vector<int>> elements_of_nodes(const Discretization<2>& d) {
  std::vector<std::vector<int>> elements(d.num_nodes);
  for (int e = 0; e < d.num_elements; ++e)
    for (int a = 0; a < d.nodes_per_element; ++a) elements[d.element(e)[a]].push_back(e);
  return elements;
}

// Linear least-squares fit over the points of a patch, evaluated at the node.
double fit_at_node(const Discretization<2>& d, const std::vector<int>& patch, const Vector<2>& node,
                   const Eigen::VectorXd& values) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double low = values[patch[0] * d.points_per_element], high = low, size2 = 0;
  int count = 0;
  for (const int pass : {0, 1}) // the size of the patch first, to make the fit free of units
    for (const int e : patch)
      for (int q = 0; q < d.points_per_element; ++q) {
        const int p = e * d.points_per_element + q;
        const Vector<2> r = Vector<2>(d.point[2 * p], d.point[2 * p + 1]) - node;
        if (pass == 0) {
          size2 = std::max(size2, r.squaredNorm());
          continue;
        }
        const Eigen::Vector3d row(1, r[0] / std::sqrt(size2), r[1] / std::sqrt(size2));
        normal += row * row.transpose();
        right += values[p] * row;
        low = std::min(low, values[p]);
        high = std::max(high, values[p]);
        ++count;
      }
  const double mean = right[0] / count;
  if (count < 4 || std::abs(normal.determinant()) < 1e-4 * count * count * count) return mean;
  return std::clamp(normal.ldlt().solve(right)[0], low, high);
}

} // namespace

Eigen::VectorXd nodal_average(const Discretization<2>& d, const Eigen::VectorXd& values) {
  require(values.size() == d.num_points(), "nodal_average", "number of values", values.size(),
          "one per quadrature point");
  const auto patches = elements_of_nodes(d);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(d.num_nodes);
  for (int n = 0; n < d.num_nodes; ++n)
    if (!patches[n].empty()) result[n] = fit_at_node(d, patches[n], d.node(n), values);
  return result;
}

} // namespace burnish

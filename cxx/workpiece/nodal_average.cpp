#include "workpiece/nodal_average.hpp"
#include "base/error.hpp"
#include <algorithm>

namespace burnish {
namespace {

// Value of the element's linear field at local node a: points are the middles of the edges opposite the
// vertices.
double at_node(const double* v, int points, int a) {
  if (points == 1) return v[0];
  if (a >= 3) return v[a - 3];
  return v[(a + 1) % 3] + v[(a + 2) % 3] - v[a];
}

} // namespace

Eigen::VectorXd nodal_average(const Discretization<2>& d, const Eigen::VectorXd& values) {
  require(values.size() == d.num_points(), "nodal_average", "number of values", values.size(),
          "one per quadrature point");
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(d.num_nodes), weight = sum;
  std::vector<double> low(d.num_nodes, 1e300), high(d.num_nodes, -1e300);
  for (int e = 0; e < d.num_elements; ++e) {
    const double* v = values.data() + e * d.points_per_element;
    double volume = 0;
    for (int q = 0; q < d.points_per_element; ++q) volume += d.weight[e * d.points_per_element + q];
    const auto [least, most] = std::minmax_element(v, v + d.points_per_element);
    for (int a = 0; a < d.nodes_per_element; ++a) {
      const int node = d.element(e)[a];
      sum[node] += volume * at_node(v, d.points_per_element, a);
      weight[node] += volume;
      low[node] = std::min(low[node], *least);
      high[node] = std::max(high[node], *most);
    }
  }
  for (int n = 0; n < d.num_nodes; ++n) sum[n] = std::clamp(sum[n] / weight[n], low[n], high[n]);
  return sum;
}

} // namespace burnish

#include "workpiece/volume_percentile.hpp"
#include "base/error.hpp"
#include <algorithm>

namespace burnish {

template <int Dim>
double volume_percentile(const Discretization<Dim>& d, const Eigen::VectorXd& values, double share,
                         double least) {
  const char* where = "volume_percentile";
  require(values.size() == d.num_points(), where, "number of values", values.size(),
          "one per quadrature point");
  require(share >= 0 && share <= 1, where, "share", share, "0 to 1");
  std::vector<std::pair<double, double>> parts; // value, volume
  double volume = 0;
  for (int p = 0; p < d.num_points(); ++p) {
    if (!(values[p] > least)) continue;
    parts.emplace_back(values[p], d.weight[p]);
    volume += d.weight[p];
  }
  if (parts.empty()) return 0;
  std::sort(parts.begin(), parts.end());
  double below = 0;
  for (const auto& [value, weight] : parts) {
    below += weight;
    if (below >= share * volume) return value;
  }
  return parts.back().first;
}

template double volume_percentile<2>(const Discretization<2>&, const Eigen::VectorXd&, double, double);
template double volume_percentile<3>(const Discretization<3>&, const Eigen::VectorXd&, double, double);

} // namespace burnish

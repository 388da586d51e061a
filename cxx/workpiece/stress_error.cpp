#include "workpiece/stress_error.hpp"
#include "base/error.hpp"
#include "material/point_traits.hpp"
#include "workpiece/nodal_average.hpp"

namespace burnish {

template <int Dim> StressError stress_error(const Discretization<Dim>& d, const std::vector<double>& stress) {
  return stress_error(d, NodalFit<Dim>(d), stress);
}

template <int Dim>
StressError stress_error(const Discretization<Dim>& d, const NodalFit<Dim>& fit,
                         const std::vector<double>& stress) {
  constexpr int components = num_stress<Dim>;
  const int points = d.num_points();
  require(stress.size() == static_cast<std::size_t>(points) * components, "stress_error", "size of stress",
          stress.size(), "num_points x num_stress");
  Eigen::VectorXd difference = Eigen::VectorXd::Zero(points);
  double norm = 0;
  for (int k = 0; k < components; ++k) {
    const double twice = k < 3 ? 1 : 2; // shear entries count twice
    const Eigen::VectorXd values =
        Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<components>>(stress.data() + k, points);
    const Eigen::VectorXd nodal = fit(values, false);
    for (int p = 0; p < points; ++p) {
      const int* nodes = d.element(p / d.points_per_element);
      double recovered = 0;
      for (int a = 0; a < d.nodes_per_element; ++a) recovered += d.shapes(p)[a] * nodal[nodes[a]];
      difference[p] += twice * (recovered - values[p]) * (recovered - values[p]);
      norm += d.weight[p] * twice * recovered * recovered;
    }
  }
  StressError error;
  double all = 0, most = -1;
  for (int e = 0; e < d.num_elements; ++e) {
    double part = 0;
    for (int p = e * d.points_per_element; p < (e + 1) * d.points_per_element; ++p)
      part += d.weight[p] * difference[p];
    all += part;
    if (part <= most) continue;
    most = part;
    error.worst = e;
  }
  error.point = difference.cwiseSqrt();
  error.relative = norm > 0 ? std::sqrt(all / norm) : 0;
  return error;
}

template StressError stress_error<2>(const Discretization<2>&, const std::vector<double>&);
template StressError stress_error<2>(const Discretization<2>&, const NodalFit<2>&,
                                     const std::vector<double>&);
template StressError stress_error<3>(const Discretization<3>&, const std::vector<double>&);
template StressError stress_error<3>(const Discretization<3>&, const NodalFit<3>&,
                                     const std::vector<double>&);

} // namespace burnish

#include "workpiece/elastic_energy.hpp"
#include "material/stress_algebra.hpp"

namespace burnish {

template <int Dim> double elastic_energy(const Workpiece<Dim>& body) {
  const auto moduli = body.law().moduli();
  const auto shear = moduli.find("G"), bulk = moduli.find("K");
  if (shear == moduli.end() || bulk == moduli.end()) return std::numeric_limits<double>::quiet_NaN();
  const double G = shear->second, K = bulk->second;
  const Discretization<Dim>& space = body.discretization();
  double sum = 0;
  for (int p = 0; p < space.num_points(); ++p) {
    const Stress<Dim> tau = point_state(body.state_old(), p).stress, s = deviator<Dim>(tau);
    const double m = mean<Dim>(tau), w = integrity_of(body.state_old(), p);
    sum += space.weight[p] * w * (contract<Dim>(s, s) / (4 * G) + m * m / (2 * K));
  }
  return sum;
}

template double elastic_energy<2>(const Workpiece<2>&);
template double elastic_energy<3>(const Workpiece<3>&);

} // namespace burnish

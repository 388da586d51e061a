#include "material/j2/backstress_return.hpp"
#include <limits>

namespace burnish {
namespace {

/// f(x) = q(s - theta X) - (3G + theta C) x - sigma_y(ep + x) and its slope, which is < 0 unless the law softens.
template <int Dim> class ReturnEquation {
public:
  ReturnEquation(const J2Parameters& material, const Stress<Dim>& s, double plastic_strain_eq,
                 const Stress<Dim>& backstress)
      : m_material(material), m_s(s), m_backstress(backstress), m_plastic_strain_eq(plastic_strain_eq) {}

  struct Value {
    double f, slope;
  };
  Value operator()(double x) const {
    const double G3 = 3 * m_material.elastic.G, gamma = m_material.kinematic.recovery;
    const double C = m_material.kinematic.modulus, theta = 1 / (1 + gamma * x);
    const Stress<Dim> eta = m_s - theta * m_backstress;
    const double q = equivalent<Dim>(eta), turn = 1.5 * contract<Dim>(eta, m_backstress) / q;
    const YieldStress yield = m_material.yield_stress(m_plastic_strain_eq + x);
    return {q - (G3 + theta * C) * x - yield.value, theta * theta * (gamma * turn - C) - G3 - yield.slope};
  }

private:
  const J2Parameters& m_material;
  const Stress<Dim>& m_s;
  const Stress<Dim>& m_backstress;
  double m_plastic_strain_eq;
};

// Newton's method within the bracket from 0, where f > 0, to `high`, where f < 0.
template <int Dim> double solved(const ReturnEquation<Dim>& equation, double high, double scale) {
  constexpr int MAX_PASSES = 100;
  constexpr double RELATIVE_ERROR = 1e-15; // of the stresses: rounding
  double low = 0, x = 0;
  for (int k = 0; k < MAX_PASSES; ++k) {
    const auto [f, slope] = equation(x);
    if (!(slope < 0) || !std::isfinite(f)) return std::numeric_limits<double>::quiet_NaN();
    if (std::abs(f) <= RELATIVE_ERROR * scale) break;
    (f > 0 ? low : high) = x;
    double next = x - f / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == x) break;
    x = next;
  }
  return x;
}

} // namespace

template <int Dim>
double backstress_increment(const J2Parameters& material, const Stress<Dim>& s, double plastic_strain_eq,
                            const Stress<Dim>& backstress) {
  const YieldStress yield = material.yield_stress(plastic_strain_eq);
  const double q2 = squared_equivalent<Dim>(s - backstress), G3 = 3 * material.elastic.G;
  if (q2 <= yield.value * yield.value) return 0;
  const KinematicHardening& law = material.kinematic;
  if (law.recovery == 0)
    return plastic_increment(*material.hardening, yield, plastic_strain_eq, std::sqrt(q2), G3 + law.modulus);
  const double scale = equivalent<Dim>(s) + equivalent<Dim>(backstress);
  return solved(ReturnEquation<Dim>(material, s, plastic_strain_eq, backstress), scale / G3, scale);
}

template <int Dim>
double backstress_return(const J2Parameters& material, Stress<Dim>& s, double& plastic_strain_eq,
                         Stress<Dim>& backstress) {
  const double x = backstress_increment<Dim>(material, s, plastic_strain_eq, backstress);
  if (x == 0) return 0;
  const double theta = 1 / (1 + material.kinematic.recovery * x);
  const Stress<Dim> eta = s - theta * backstress;
  const Stress<Dim> flow = (x / equivalent<Dim>(eta)) * eta; // x n
  s -= 3 * material.elastic.G * flow;
  backstress = theta * (backstress + material.kinematic.modulus * flow);
  plastic_strain_eq += x;
  return x;
}

// eta = s - theta X, n = eta/q(eta): d(eta) = ds - theta dX + gamma theta^2 X dx, f' dx = H' d ep - (3/2) n:(ds - theta dX)
template <int Dim>
double backstress_return(const J2Parameters& material, Stress<Dim>& s, double& plastic_strain_eq,
                         Stress<Dim>& backstress, BackstressDerivative<Dim>& derivative) {
  const Stress<Dim> s_trial = s, X = backstress;
  const double start = plastic_strain_eq;
  const double x = backstress_return<Dim>(material, s, plastic_strain_eq, backstress);
  if (x == 0) return 0;
  const double G3 = 3 * material.elastic.G, C = material.kinematic.modulus;
  const double gamma = material.kinematic.recovery, theta = 1 / (1 + gamma * x);
  const Stress<Dim> eta = s_trial - theta * X;
  const double q = equivalent<Dim>(eta), H = material.yield_stress(plastic_strain_eq).slope;
  const Stress<Dim> n = eta / q;
  const double slope = ReturnEquation<Dim>(material, s_trial, start, X)(x).slope;

  StressByIncrement<Dim> eta_by = derivative.s - theta * derivative.backstress; // at fixed x so far
  const ScalarByIncrement<Dim> x_by =
      (H * derivative.plastic_strain_eq - 1.5 * contraction_row<Dim>(n) * eta_by) / slope;
  eta_by.noalias() += gamma * theta * theta * X * x_by;
  const ScalarByIncrement<Dim> q_by = 1.5 * contraction_row<Dim>(n) * eta_by;
  const StressByIncrement<Dim> flow_by = n * x_by + (x / q) * (eta_by - n * q_by); // of x n
  derivative.s -= G3 * flow_by;
  derivative.backstress = theta * (derivative.backstress + C * flow_by);
  derivative.backstress.noalias() -= gamma * theta * backstress * x_by; // d(theta)/theta = -gamma theta dx
  derivative.plastic_strain_eq += x_by;
  return x;
}

template double backstress_increment<2>(const J2Parameters&, const Stress<2>&, double, const Stress<2>&);
template double backstress_increment<3>(const J2Parameters&, const Stress<3>&, double, const Stress<3>&);
template double backstress_return<2>(const J2Parameters&, Stress<2>&, double&, Stress<2>&);
template double backstress_return<3>(const J2Parameters&, Stress<3>&, double&, Stress<3>&);
template double backstress_return<2>(const J2Parameters&, Stress<2>&, double&, Stress<2>&,
                                     BackstressDerivative<2>&);
template double backstress_return<3>(const J2Parameters&, Stress<3>&, double&, Stress<3>&,
                                     BackstressDerivative<3>&);

} // namespace burnish

#include "material/rate_law.hpp"

namespace burnish {

template <int Dim>
StressByIncrement<Dim> rate_moduli(const J2Parameters& material, const Stress<Dim>& stress, bool plastic) {
  StressByIncrement<Dim> moduli = deviatoric_moduli<Dim>(material);
  const Stress<Dim> s = deviator<Dim>(stress);
  if (plastic && squared_equivalent<Dim>(s) > 0) {
    const ScalarByIncrement<Dim> power = contraction_row<Dim>(s) * strain_by_increment<Dim>(); // s:d
    moduli.noalias() -= plastic_factor<Dim>(material, s) * s * power;
  }
  moduli.template topLeftCorner<3, 3>().array() += material.K;
  moduli.template rightCols<1>() += spin_rate(stress);
  return moduli;
}

template <int Dim>
double forward_euler(const J2Parameters& material, const StepKinematics<Dim>& kin, const Stress<Dim>& De,
                     Stress<Dim>& s, double& plastic_strain_eq, bool yielded) {
  if (!loads<Dim>(material, s, plastic_strain_eq, kin.strain, yielded)) {
    s += De;
    return 0;
  }
  const double power = contract<Dim>(s, kin.strain), G3 = 3 * material.G; // s:dd
  const double dep = G3 * power / (equivalent<Dim>(s) * (G3 + material.hardening_modulus));
  s += De - plastic_factor<Dim>(material, s) * power * s;
  plastic_strain_eq += dep;
  return dep;
}

template <int Dim>
StressByIncrement<Dim> forward_euler_by_increment(const J2Parameters& material,
                                                  const StepKinematics<Dim>& kin, const Stress<Dim>& s_old,
                                                  const StressByIncrement<Dim>& s_old_by,
                                                  double plastic_strain_eq, bool yielded) {
  StressByIncrement<Dim> by = deviatoric_moduli<Dim>(material) + s_old_by;
  if (!loads<Dim>(material, s_old, plastic_strain_eq, kin.strain, yielded)) return by;
  // c (s:dd) s with q, and so c, unchanged by the rotation
  const double c = plastic_factor<Dim>(material, s_old), power = contract<Dim>(s_old, kin.strain);
  const ScalarByIncrement<Dim> power_by =
      contraction_row<Dim>(s_old) * strain_by_increment<Dim>() + contraction_row<Dim>(kin.strain) * s_old_by;
  by.noalias() -= c * s_old * power_by;
  by -= c * power * s_old_by;
  return by;
}

template StressByIncrement<2> rate_moduli<2>(const J2Parameters&, const Stress<2>&, bool);
template double forward_euler<2>(const J2Parameters&, const StepKinematics<2>&, const Stress<2>&, Stress<2>&,
                                 double&, bool);
template StressByIncrement<2> forward_euler_by_increment<2>(const J2Parameters&, const StepKinematics<2>&,
                                                            const Stress<2>&, const StressByIncrement<2>&,
                                                            double, bool);

} // namespace burnish

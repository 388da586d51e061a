#include "material/j2/rate_law.hpp"
#include "material/j2/backstress_return.hpp"

namespace burnish {

template <int Dim>
StressByIncrement<Dim> rate_moduli(const J2Parameters& material, const Stress<Dim>& stress,
                                   double plastic_strain_eq, bool plastic, const double* backstress) {
  StressByIncrement<Dim> moduli = deviatoric_moduli<Dim>(material.elastic);
  Stress<Dim> s = deviator<Dim>(stress);
  const bool kinematic = material.kinematic.exists();
  if (kinematic) s -= Eigen::Map<const Stress<Dim>>(backstress);
  if (plastic && squared_equivalent<Dim>(s) > 0) {
    const double moving =
        kinematic ? kinematic_modulus<Dim>(material.kinematic, s, Eigen::Map<const Stress<Dim>>(backstress))
                  : 0;
    const ScalarByIncrement<Dim> power = contraction_row<Dim>(s) * strain_by_increment<Dim>(); // s:d
    moduli.noalias() -= plastic_factor<Dim>(material, s, plastic_strain_eq, moving) * s * power;
  }
  moduli.template topLeftCorner<3, 3>().array() += material.elastic.K;
  moduli.template rightCols<PointTraits<Dim>::num_rotations>() += spin_rate(stress);
  return moduli;
}

template <int Dim>
double forward_euler(const J2Parameters& material, const StepKinematics<Dim>& kin,
                     const Stress<Dim>& elastic_increment, Stress<Dim>& s, double& plastic_strain_eq,
                     bool yielded) {
  if (!loads<Dim>(material, s, plastic_strain_eq, kin.strain, yielded)) {
    s += elastic_increment;
    return 0;
  }
  const double power = contract<Dim>(s, kin.strain), G3 = 3 * material.elastic.G; // s:dd
  const double H = material.yield_stress(plastic_strain_eq).slope;
  const double increment = G3 * power / (equivalent<Dim>(s) * (G3 + H));
  s += elastic_increment - plastic_factor<Dim>(material, s, plastic_strain_eq) * power * s;
  plastic_strain_eq += increment;
  return increment;
}

template <int Dim>
StressByIncrement<Dim> forward_euler_by_increment(const J2Parameters& material,
                                                  const StepKinematics<Dim>& kin, const Stress<Dim>& s_old,
                                                  const StressByIncrement<Dim>& s_old_by,
                                                  double plastic_strain_eq, bool yielded) {
  StressByIncrement<Dim> by = deviatoric_moduli<Dim>(material.elastic) + s_old_by;
  if (!loads<Dim>(material, s_old, plastic_strain_eq, kin.strain, yielded)) return by;
  // c (s:dd) s with q, and so c, unchanged by the rotation
  const double c = plastic_factor<Dim>(material, s_old, plastic_strain_eq);
  const double power = contract<Dim>(s_old, kin.strain);
  const ScalarByIncrement<Dim> power_by =
      contraction_row<Dim>(s_old) * strain_by_increment<Dim>() + contraction_row<Dim>(kin.strain) * s_old_by;
  by.noalias() -= c * s_old * power_by;
  by -= c * power * s_old_by;
  return by;
}

template StressByIncrement<2> rate_moduli<2>(const J2Parameters&, const Stress<2>&, double, bool,
                                             const double*);
template StressByIncrement<3> rate_moduli<3>(const J2Parameters&, const Stress<3>&, double, bool,
                                             const double*);
template double forward_euler<2>(const J2Parameters&, const StepKinematics<2>&, const Stress<2>&, Stress<2>&,
                                 double&, bool);
template double forward_euler<3>(const J2Parameters&, const StepKinematics<3>&, const Stress<3>&, Stress<3>&,
                                 double&, bool);
template StressByIncrement<2> forward_euler_by_increment<2>(const J2Parameters&, const StepKinematics<2>&,
                                                            const Stress<2>&, const StressByIncrement<2>&,
                                                            double, bool);
template StressByIncrement<3> forward_euler_by_increment<3>(const J2Parameters&, const StepKinematics<3>&,
                                                            const Stress<3>&, const StressByIncrement<3>&,
                                                            double, bool);

} // namespace burnish

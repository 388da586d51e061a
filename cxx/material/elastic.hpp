#pragma once
// Isotropic elasticity E of the rate law (3.1): stress = K tr(d) I + 2G dev(d).
#include "material/step_kinematics.hpp"

namespace burnish {

/// 2G dev(d) [stress].
template <int Dim> Stress<Dim> deviatoric_stress(const J2Parameters& material, const Stress<Dim>& strain) {
  return 2 * material.G * deviator<Dim>(strain);
}

/// Derivative of 2G dev(dd) with respect to the step's increments.
template <int Dim> StressByIncrement<Dim> deviatoric_moduli(const J2Parameters& material) {
  const double third = 2 * material.G / 3;
  StressByIncrement<Dim> moduli = 2 * material.G * strain_by_increment<Dim>();
  moduli.template topLeftCorner<3, 3>().setConstant(-third);
  moduli.diagonal().template head<3>().setConstant(2 * third);
  return moduli;
}

/// What the stress update starts from: the old stress turned into the new frame and the elastic increment.
template <int Dim> struct ElasticTrial {
  Stress<Dim> s_old; ///< deviator of R tau_old R' [stress]
  double mean = 0;   ///< mean stress at the end of the step, elastic in every update [stress]
  Stress<Dim> De;    ///< 2G dev(dd) [stress]
};

template <int Dim>
ElasticTrial<Dim> elastic_trial(const J2Parameters& material, const StepKinematics<Dim>& kin,
                                const Stress<Dim>& stress_old) {
  ElasticTrial<Dim> trial;
  const Stress<Dim> turned = rotated(stress_old, kin.cos_2alpha, kin.sin_2alpha);
  const double mean_old = mean<Dim>(turned);
  trial.s_old = turned;
  trial.s_old.template head<3>().array() -= mean_old;
  trial.mean = mean_old + 3 * material.K * mean<Dim>(kin.strain);
  trial.De = deviatoric_stress<Dim>(material, kin.strain);
  return trial;
}

} // namespace burnish

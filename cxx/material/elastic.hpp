#pragma once
// Isotropic elasticity E of the rate law, METHOD.md (1.6): stress = K tr(d) I + 2G dev(d).
#include "material/law_parameter.hpp"
#include "material/step_kinematics_in_space.hpp"

namespace burnish {

struct ElasticModuli {
  double K = 0; ///< bulk modulus [stress]
  double G = 0; ///< shear modulus [stress]
  /// K = 2G(1+nu)/(3(1-2nu)), G = E/(2(1+nu)).
  /// @throws std::invalid_argument if G <= 0 (E <= 0), nu outside (-1, 0.5), or a number is not finite
  static ElasticModuli from_shear(double G, double nu, const char* where = "ElasticModuli::from_shear");
  static ElasticModuli from_young(double E, double nu, const char* where = "ElasticModuli::from_young");
  /// From nu and exactly one of G and E. @throws std::invalid_argument "where: ..." also if one is missing
  static ElasticModuli from_numbers(const LawNumbers& numbers, const char* where);
};
/// What from_numbers reads: G, E, nu.
const std::vector<LawParameter>& elastic_parameters();
/// @throws std::invalid_argument naming `where` unless K, G > 0, both finite
void require_valid(const ElasticModuli& elastic, const char* where);

/// 2G dev(d) [stress].
template <int Dim> Stress<Dim> deviatoric_stress(const ElasticModuli& elastic, const Stress<Dim>& strain) {
  return 2 * elastic.G * deviator<Dim>(strain);
}

/// Derivative of 2G dev(dd) with respect to the step's increments.
template <int Dim> StressByIncrement<Dim> deviatoric_moduli(const ElasticModuli& elastic) {
  const double third = 2 * elastic.G / 3;
  StressByIncrement<Dim> moduli = 2 * elastic.G * strain_by_increment<Dim>();
  moduli.template topLeftCorner<3, 3>().setConstant(-third);
  moduli.diagonal().template head<3>().setConstant(2 * third);
  return moduli;
}

/// What the stress update starts from: the old stress turned into the new frame and the elastic increment.
template <int Dim> struct ElasticTrial {
  Stress<Dim> s_old;             ///< deviator of R tau_old R' [stress]
  double mean = 0;               ///< mean stress at the end of the step, elastic in every update [stress]
  Stress<Dim> elastic_increment; ///< 2G dev(dd) [stress]
};

template <int Dim>
ElasticTrial<Dim> elastic_trial(const ElasticModuli& elastic, const StepKinematics<Dim>& kin,
                                const Stress<Dim>& stress_old) {
  ElasticTrial<Dim> trial;
  const Stress<Dim> turned = rotated(stress_old, kin);
  const double mean_old = mean<Dim>(turned);
  trial.s_old = turned;
  trial.s_old.template head<3>().array() -= mean_old;
  trial.mean = mean_old + 3 * elastic.K * mean<Dim>(kin.strain);
  trial.elastic_increment = deviatoric_stress<Dim>(elastic, kin.strain);
  return trial;
}

} // namespace burnish

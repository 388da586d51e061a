#pragma once
// What the self-checks ask of a law that the core carries out.
#include "workpiece/workpiece.hpp"

namespace burnish {

/// The law, if stress comes from it by isotropic elasticity and flow at constant volume: it has moduli G and K and an
/// accumulated plastic strain; else null.
/// @param workpiece null: unknown
template <int Dim> const MaterialLaw<Dim>* known_law(const Workpiece<Dim>* workpiece) {
  if (!workpiece) return nullptr;
  const MaterialLaw<Dim>& law = workpiece->law();
  if (workpiece->user_defined() || !law.has_moduli() ||
      law.internal_variables().find("plastic_strain_eq") < 0)
    return nullptr;
  const auto moduli = law.moduli();
  return moduli.count("G") && moduli.count("K") ? &law : nullptr;
}

/// Accumulated plastic strain of the accepted state at all points [-].
template <int Dim>
Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<>> plastic_strains(const Workpiece<Dim>& workpiece) {
  const auto& variables = workpiece.law().internal_variables();
  const double* first =
      workpiece.state_old().internal.data() + variables.offset(variables.find("plastic_strain_eq"));
  return {first, workpiece.discretization().num_points(), Eigen::InnerStride<>(variables.size())};
}

/// Whether any point of a known law has flowed.
template <int Dim> bool flowed(const Workpiece<Dim>& workpiece) {
  return known_law(&workpiece) && plastic_strains(workpiece).maxCoeff() > 0;
}

} // namespace burnish

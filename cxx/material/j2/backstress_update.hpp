#pragma once
// One step of one quadrature point with J2 and a back stress: what point_update.hpp hands on where there is one.
#include "material/j2/backstress_return.hpp"
#include "material/j2/point_update.hpp"

namespace burnish {

/// The back stress at the start, turned by the step's rotation like the stress [stress].
template <int Dim> Stress<Dim> turned_backstress(const J2Start<Dim>& old, const StepKinematics<Dim>& kin) {
  return rotated(Stress<Dim>(Eigen::Map<const Stress<Dim>>(old.backstress)), kin);
}

/// As updated_point, with J2End::backstress.
template <int Dim>
J2End<Dim> updated_with_backstress(const J2Parameters& material, const PointScheme& scheme,
                                   const J2Start<Dim>& old, const StepKinematics<Dim>& kin,
                                   const ElasticTrial<Dim>& trial);

/// As consistent_moduli: d tau/dy, exact.
template <int Dim>
StressByIncrement<Dim> moduli_with_backstress(const J2Parameters& material, const PointScheme& scheme,
                                              const J2Start<Dim>& old, const StepKinematics<Dim>& kin,
                                              const ElasticTrial<Dim>& trial);

} // namespace burnish

#pragma once
// Where the internal variables of J2 are among the numbers of a point.
#include "material/internal_variables.hpp"
#include "material/j2/parameters.hpp"

namespace burnish {

inline constexpr int EP = 0;         ///< plastic_strain_eq
inline constexpr int BACKSTRESS = 1; ///< first component of backstress, where material.kinematic exists()

/// plastic_strain_eq, and backstress with kinematic hardening.
std::vector<InternalVariable> j2_internal_variables(const J2Parameters& material);

/// s - X at a point: what flows [stress]. @param s deviator, @param internal variables, of the same instant
template <int Dim>
Stress<Dim> relative_stress(const J2Parameters& material, const Stress<Dim>& s, const double* internal) {
  if (!material.kinematic.exists()) return s;
  return s - Eigen::Map<const Stress<Dim>>(internal + BACKSTRESS);
}

} // namespace burnish

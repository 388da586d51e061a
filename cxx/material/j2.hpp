#pragma once
// J2 plasticity with linear isotropic hardening: parameters and the vocabulary of its updates
// (method.md section 1).
#include "base/types.hpp"

namespace burnish {

/// Stress and strain components kept at a point. Dim 2 (plane strain): xx, yy, zz, xy. Dim 3: xx, yy, zz, xy,
/// yz, zx. Shear entries are tensor components (not doubled).
template <int Dim> inline constexpr int num_stress = Dim == 2 ? 4 : 6;
template <int Dim> using Stress = Eigen::Matrix<double, num_stress<Dim>, 1>;

struct J2Parameters {
  double K = 0;                 ///< bulk modulus [stress]
  double G = 0;                 ///< shear modulus [stress]
  double yield_stress = 0;      ///< initial yield stress sigma_0 [stress]
  double hardening_modulus = 0; ///< H' = d sigma_y / d plastic_strain_eq [stress]
  /// K = 2G(1+nu)/(3(1-2nu)), G = E/(2(1+nu)).
  /// @throws std::invalid_argument if G <= 0 (E <= 0), nu outside (-1, 0.5), yield_stress <= 0,
  ///         hardening_modulus < 0, or a number is not finite
  static J2Parameters from_shear(double G, double nu, double yield_stress, double hardening_modulus);
  static J2Parameters from_young(double E, double nu, double yield_stress, double hardening_modulus);
};

/// @throws std::invalid_argument naming `where` unless K, G, yield_stress > 0, hardening_modulus >= 0,
///         all finite
void require_valid(const J2Parameters& material, const char* where);

/// Yield stress sigma_y(ep) = sigma_0 + H' ep [stress].
inline double yield_stress_at(const J2Parameters& material, double plastic_strain_eq) {
  return material.yield_stress + material.hardening_modulus * plastic_strain_eq;
}

enum class StressUpdate {
  SUBSTEPPED,    ///< sub-stepped radial return on the quadratic strain path (algorithms.md section 2)
  SINGLE,        ///< one radial return per step
  FORWARD_EULER, ///< rate (3.1) times the increment, the article's scheme: no return, leaves the surface
};
/// Frame in which the strain increments meet the turned old stress.
enum class StrainFrame {
  MIDPOINT, ///< dd and dd_p as they are (method.md, algorithms.md): first order where the body spins
  END,      ///< dd turned by the other half of the rotation, dd_p by the whole: second order, same cost
};
enum class TangentKind {
  CONSISTENT, ///< linearization of the chosen finite-step update
  RATE,       ///< rate tangent of (1.11), (3.1) at the current state
  ELASTIC,    ///< elastic moduli with the geometric terms
};

} // namespace burnish

#pragma once
// What a workpiece needs to go on from an accepted step: one plain value.
#include "material/material_law.hpp"
#include "mesh/discretization.hpp"

namespace burnish {

/// Plain data, can be copied, written and read. Point-major arrays. A workpiece that is given a copy goes on
/// to the same bits.
template <int Dim> struct WorkpieceState {
  Eigen::VectorXd displacement; ///< num_dofs [length]
  std::vector<double> F;        ///< num_points x num_gradient: deformation gradient (Gradient) [-]
  std::vector<double>
      stress; ///< num_points x num_stress: Kirchhoff stress [stress], effective (METHOD.md 1.12)
  std::vector<double> internal; ///< num_points x InternalVariables::size(): the law's internal variables
  std::vector<double> strain_increment; ///< num_points x num_stress: dd of the step that ended here [-]
  std::vector<char> plastic;            ///< num_points: inelastic flow happened in that step
  double dt = 0;                        ///< length of that step [time]; 0: there was none
  // Damage and healing (METHOD.md 1.12), num_points each; empty: no damage is defined, every integrity is 1.
  std::vector<double> integrity;      ///< 0 < w <= 1 [-]: the body carries w times `stress`
  std::vector<double> integrity_rate; ///< change of w a full step; < 0 damage, > 0 healing, 0: at rest
  std::vector<double> integrity_goal; ///< w at which that change ends
  bool tracks_integrity() const { return !integrity.empty(); }
};

/// Undeformed and free of stress.
template <int Dim>
WorkpieceState<Dim> initial_state(const Discretization<Dim>& mesh, const InternalVariables<Dim>& internal);

/// @throws std::invalid_argument "where: ..." on wrong sizes, numbers that are not finite, or det F <= 0
template <int Dim>
void require_valid(const WorkpieceState<Dim>& state, const Discretization<Dim>& mesh,
                   const InternalVariables<Dim>& internal, const char* where);

// One point of it; nobody checks that there is one.

/// With the effective stress; points into the state.
template <int Dim> PointState<Dim> point_state(const WorkpieceState<Dim>& state, int point) {
  const std::size_t p = point, num_internal = state.internal.size() / state.plastic.size();
  return {Eigen::Map<const Gradient<Dim>>(state.F.data() + p * num_gradient<Dim>),
          Eigen::Map<const Stress<Dim>>(state.stress.data() + p * num_stress<Dim>),
          state.internal.data() + p * num_internal,
          Eigen::Map<const Stress<Dim>>(state.strain_increment.data() + p * num_stress<Dim>),
          state.plastic[p] != 0};
}
template <int Dim> double integrity_of(const WorkpieceState<Dim>& state, int point) {
  return state.integrity.empty() ? 1 : state.integrity[point];
}
/// Kirchhoff stress that the body carries, METHOD.md (1.27), and the first Piola stress of it [stress].
/// @param small_strain of the law
template <int Dim> Stress<Dim> carried_stress(const WorkpieceState<Dim>& state, int point) {
  return integrity_of(state, point) * point_state(state, point).stress;
}
template <int Dim>
Gradient<Dim> carried_piola(const WorkpieceState<Dim>& state, int point, bool small_strain) {
  const PointState<Dim> at = point_state(state, point);
  return integrity_of(state, point) *
         first_piola(Stress<Dim>(at.stress), pull_back<Dim>(Gradient<Dim>(at.F), small_strain));
}

} // namespace burnish

#pragma once
// What acts on the body beside the tools: supports that move, external forces, a soft hold, the viscosity of a march.
#include "run/external_forces.hpp"
#include "run/hold.hpp"
#include "run/supports.hpp"

namespace burnish {

/// Resists every node's way from where it was at the start of a piece: k V (u - from), ALGORITHMS.md 9.4.
struct Viscosity {
  double stiffness = 0; ///< k, per reference volume [stress/length^2]; 0: none
  Eigen::VectorXd from; ///< displacement at the start of the piece [length]
};

template <int Dim> struct BodyLoads {
  Supports<Dim> supports;       ///< prescribed displacement; takes effect with the next begin
  ExternalForces<Dim> external; ///< those given last take effect with the next begin
  Hold<Dim> hold;               ///< a new one begins with the next begin

  Viscosity viscosity{}; ///< of the piece under way

  /// @param mesh, body must outlive it
  BodyLoads(const Mesh<Dim>& mesh, const BodyView<Dim>& body)
      : supports(body), external(body), hold(mesh, body), m_springs(mesh, body) {}
  const NodalSprings<Dim>& springs() const { return m_springs; }
  /// Force of the viscosity on the nodes at u [force].
  Eigen::VectorXd viscous_force(const Eigen::VectorXd& u) const {
    return m_springs.force(viscosity.stiffness, u, viscosity.from);
  }
  /// Residual force at u, t: the internal nodal force less that of external forces, hold and viscosity; of another size it
  /// stays as it is.
  Eigen::VectorXd residual(const Eigen::VectorXd& u, double t, Eigen::VectorXd internal) const {
    if (u.size() != internal.size()) return internal; // refused by who asks
    external.take_off(internal);
    hold.add_force(u, t, internal);
    if (viscosity.stiffness > 0) internal -= viscous_force(u);
    return internal;
  }
  /// K, or, where hold or viscosity act at t, a copy in `place` with their stiffness.
  const NodeBlockMatrix<Dim>& with_springs(const NodeBlockMatrix<Dim>& K, double t,
                                           NodeBlockMatrix<Dim>& place) const {
    if (!hold.acts(t) && viscosity.stiffness == 0) return K;
    place = K;
    add_springs(t, place);
    return place;
  }
  /// Adds that stiffness to K.
  void add_springs(double t, NodeBlockMatrix<Dim>& K) const {
    hold.add_stiffness(t, K);
    if (viscosity.stiffness > 0) m_springs.add_stiffness(viscosity.stiffness, K);
  }

private:
  NodalSprings<Dim> m_springs;
};

} // namespace burnish

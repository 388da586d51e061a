#pragma once
// What acts on the body beside the tools: supports that move, external forces, a soft hold.
#include "run/external_forces.hpp"
#include "run/hold.hpp"
#include "run/supports.hpp"

namespace burnish {

template <int Dim> struct BodyLoads {
  Supports<Dim> supports;       ///< prescribed displacement; takes effect with the next begin
  ExternalForces<Dim> external; ///< those given last take effect with the next begin
  Hold<Dim> hold;               ///< a new one begins with the next begin

  /// @param mesh, body must outlive it
  BodyLoads(const Mesh<Dim>& mesh, const BodyView<Dim>& body)
      : supports(body), external(body), hold(mesh, body) {}
  /// Residual force at u, t: the internal nodal force less that of external forces and hold; of another size it stays as it is.
  Eigen::VectorXd residual(const Eigen::VectorXd& u, double t, Eigen::VectorXd internal) const {
    if (u.size() != internal.size()) return internal; // refused by who asks
    external.take_off(internal);
    hold.add_force(u, t, internal);
    return internal;
  }
  /// The tangent with the stiffness of the hold at t.
  const NodeBlockMatrix<Dim>& with_hold(const NodeBlockMatrix<Dim>& K, double t) {
    if (!hold.acts(t)) return K;
    m_held = K;
    hold.add_stiffness(t, m_held);
    return m_held;
  }

private:
  NodeBlockMatrix<Dim> m_held;
};

} // namespace burnish

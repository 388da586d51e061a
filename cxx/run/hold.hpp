#pragma once
// A soft hold of a body that nothing supports until tools touch it: springs from its nodes to where they were when the
// hold began, that fade to nothing (METHOD.md 3.16).
#include "run/nodal_springs.hpp"
#include <limits>
#include <string>

namespace burnish {

/// What a hold needs to go on. Plain data.
struct HoldState {
  double stiffness = 0; ///< of the springs at the start, per reference volume [stress/length^2]; 0: no hold
  double from = 0;      ///< start of the step in which it began [time]
  double until = -std::numeric_limits<double>::infinity(); ///< instant from which on it is gone [time]
  Eigen::VectorXd
      origin;        ///< displacement that the springs pull to; empty: that at the start of the next step
  double factor = 0; ///< part of the stiffness in the accepted state
  double share =
      0; ///< what it carried in the last accepted state with a hold: sum of the norms of its nodal forces, over
         ///< the load
};

template <int Dim> class Hold {
public:
  /// @param mesh, body must outlive it
  Hold(const Mesh<Dim>& mesh, const BodyView<Dim>& body) : m_springs(mesh, body) {}

  /// A new hold from the next step on, in place of an earlier one.
  /// @param stiffness > 0 at its start, per reference volume; it falls linearly in time to 0 at `until`
  /// @throws std::invalid_argument for a stiffness that is not finite and > 0, an instant that is not finite
  void set(double stiffness, double until);
  /// A step begins at t from u: the hold begins there, if it is new.
  /// @throws std::invalid_argument if it would end before
  void begin(double t, const Eigen::VectorXd& u);
  /// Part of the stiffness at an instant: 1 at the start, 0 from `until` on.
  double factor(double t) const;
  bool acts(double t) const { return factor(t) > 0; }
  /// Force on the nodes of the body at u, num_dofs, 0 at given components [force]; METHOD.md (3.17).
  Eigen::VectorXd force(const Eigen::VectorXd& u, double factor) const;
  /// Takes that force off the residual force, and adds its stiffness to the tangent.
  void add_force(const Eigen::VectorXd& u, double t, Eigen::VectorXd& R) const;
  void add_stiffness(double t, NodeBlockMatrix<Dim>& K) const;
  /// Sum of the norms of its nodal forces [force].
  double carried(const Eigen::VectorXd& u, double t) const;
  /// A step has been accepted at u, t. @param load of the tolerance [force]
  void accept(const Eigen::VectorXd& u, double t, double load);

  const HoldState& state() const { return m_state; }
  void set_state(const HoldState& state) { m_state = state; }
  /// A line on a hold that carries more than `NOTICED` of the load, or did so when it ended; "": none.
  std::string warning() const;
  static constexpr double NOTICED = 1e-3;

private:
  NodalSprings<Dim> m_springs;
  HoldState m_state;
};

} // namespace burnish

#pragma once
// Residual of a contact state and its consistency: the convergence test of a step (ALGORITHMS.md 5.1,
// METHOD.md 3.1).
#include "contact/body_view.hpp"
#include "contact/contact_model.hpp"
#include "contact/tolerances.hpp"

namespace burnish {

struct Balance {
  /// Largest unbalanced force: free nodes, sliding rows, tool rows over lever. What belongs to a tool with a tolerance
  /// of its own counts in proportion: times the common tolerance over it [force]
  double residual = 0;
  double load =
      0; ///< size of the load: sum of contact force norms; where they are none beside those of the supports,
         ///< that of the supports [force]
  int worst_dof = -1;        ///< dof or -1 if the worst row is not a free node
  int worst_coordinate = -1; ///< coordinate or -1
  /// sum X_k . F_n per coordinate: the generalized forces on the tools, METHOD.md (2.8); of a coordinate that others
  /// follow with what they hand on, METHOD.md (2.10)
  Eigen::VectorXd generalized_force;
  Eigen::VectorXd tool_residual; ///< generalized_force - Q_k over the lever, zero under motion [force]
  /// Per tool: sum of the norms of its contact forces, or its prescribed forces over their levers if that is more [force]
  Eigen::VectorXd tool_load;
  int inconsistent = 0;                    ///< nodes whose state contradicts force, slip or gap
  double friction = 0, friction_limit = 0; ///< sums of |T| and of its limit over the contact nodes [force]
  double penetration = 0;                  ///< deepest penetration of a free candidate >= 0 [length]
};

/// Whose balance is asked for.
template <int Dim> struct BalancedState {
  const ContactModel<Dim>& model;
  const BodyView<Dim>& body;
  const ContactState<Dim>& contact;
  const PrescribedValues& prescribed;
  const Eigen::VectorXd &u, &R; ///< displacement; internal minus external nodal force [force]; num_dofs
  Tolerances tolerance;
  double held = 0; ///< what carries the body beside tools and supports [force]
};
template <int Dim> Balance balance(const BalancedState<Dim>& state);

} // namespace burnish

#pragma once
// Residual of a contact state and its consistency: the convergence test of a step (algorithms.md 5.1,
// method.md 3).
#include "contact/body_view.hpp"
#include "contact/contact_model.hpp"
#include "stepping/options.hpp"

namespace burnish {

struct Balance {
  double residual = 0; ///< largest unbalanced force: free nodes, sliding rows, tool rows over lever [force]
  double load = 0;     ///< size of the load: sum of contact force norms [force]
  int worst_dof = -1;  ///< dof or -1 if the worst row is not a free node
  int worst_coordinate = -1; ///< coordinate or -1
  Eigen::VectorXd
      tool_force; ///< sum X_k . F_n per coordinate: what the drives give the tools (article eq. 1.6)
  Eigen::VectorXd
      tool_residual;    ///< tool_force - Q_k over the lever arm, zero for coordinates under motion [force]
  int inconsistent = 0; ///< nodes whose state contradicts force, slip or gap
  double friction = 0, friction_limit = 0; ///< sums of |T| and of its limit over the contact nodes [force]
  double penetration = 0;                  ///< deepest penetration of a free candidate >= 0 [length]
};

/// @param R internal minus external nodal force, num_dofs [force]
/// @param force_tolerance, gap_tolerance absolute tolerances for the state tests
template <int Dim>
Balance balance(const ContactModel<Dim>& model, const BodyView<Dim>& body, const ContactState<Dim>& state,
                const Program& program, const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                double force_tolerance, double gap_tolerance, double offset_tolerance);

} // namespace burnish

#pragma once
// Contact states inside an iteration: primal-dual active set on the dense block (algorithms.md 5.3).
#include "contact/contact_block.hpp"
#include "stepping/balance.hpp"

namespace burnish {

/// One linear contact problem: the window of candidates that the factor keeps, and the increment without
/// contact.
template <int Dim> struct WindowProblem {
  const std::vector<int>* window = nullptr;     ///< candidate numbers (index into ContactModel::candidates)
  const Eigen::MatrixXd* flexibility = nullptr; ///< C over the window
  Eigen::VectorXd shift;                        ///< see ContactBlockInput, Dim*window, or empty
  Eigen::VectorXd free_increment;               ///< (K^-1(-R)) on the window
  const Eigen::VectorXd* u = nullptr;           ///< displacement at the linearization point, num_dofs
  const Eigen::VectorXd* R = nullptr;           ///< residual force there, num_dofs
  const std::vector<ContactNode<Dim>>* entry =
      nullptr; ///< per candidate: where a node that touches now would stick
  std::vector<int>* releases =
      nullptr; ///< per candidate: how often it was released in this step, counted here
  double force_tolerance = 0, gap_tolerance = 0;
  bool adapt = true; ///< false: states stay as they are (event stepping)
  int max_passes = 12;
  GeometricTerms terms = GeometricTerms::COMPLETE;
};

template <int Dim> struct WindowSolution {
  bool singular = false;
  int weakest_coordinate = -1;
  int passes = 0;
  ContactState<Dim> state; ///< states, s + ds and q + dq
  std::vector<char> fresh; ///< per candidate: came into contact in this call
  Eigen::VectorXd F;       ///< contact force on the window, Dim*window [force]
  Eigen::VectorXd load;    ///< F plus what the shift carries, the load of the factor [force]
};

/// Solves the block, tests every window node, changes states and repeats until nothing changes.
/// A sticking node with N < 0 first slides; only a sliding node is released (method.md section 5).
template <int Dim>
WindowSolution<Dim> solve_window(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                 const Program& program, const ContactState<Dim>& state,
                                 const WindowProblem<Dim>& problem);

/// Makes one node of a tool stick where a coordinate under force would otherwise only meet sliding friction:
/// the sliding node with the smallest slip.
/// @param refused per candidate: sticking was tried and exceeded the friction, taken last; may be empty
/// @returns its candidate number or -1 if nothing had to be done
template <int Dim>
int ensure_support(const ContactModel<Dim>& model, const Program& program, ContactState<Dim>& state,
                   const std::vector<char>& refused = {});

} // namespace burnish

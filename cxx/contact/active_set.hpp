#pragma once
// Contact states inside an iteration: primal-dual active set on the dense block (ALGORITHMS.md 5.3), and its tests alone
// for iterations by a sparse solver.
#include "contact/body_view.hpp"
#include "contact/contact_block.hpp"
#include "contact/tied_edges.hpp"

namespace burnish {

/// Tolerances and bounds of the state tests.
struct ActiveSetOptions {
  ContactTolerance tolerance; ///< of forces and backward slips
  Eigen::VectorXd tool_force; ///< per tool: its own tolerance of forces [force]; empty: the common one
  double gap = 0;             ///< penetration that does not count [length]
  int max_passes = 12;        ///< passes over the window per iteration
  int max_neutral_trials = 4; ///< a neutral point is looked for that often (stick_at_neutral_point)
  ContactTolerance tolerance_of(int tool) const {
    return {tool_force.size() > 0 ? tool_force[tool] : tolerance.force, tolerance.slip};
  }
};

/// Where free nodes would stick if they touched now, and how often each was released in this step.
template <int Dim> struct EntryPlaces {
  std::vector<ContactNode<Dim>> nodes; ///< per candidate
  std::vector<int> releases;           ///< per candidate, counted by the tests
};

/// One linear contact problem: the window of candidates that the factor keeps, and the increment without
/// contact.
template <int Dim> struct WindowProblem {
  const std::vector<int>* window = nullptr; ///< candidate numbers (index into ContactModel::candidates)
  ActiveCholesky* flexibility = nullptr;    ///< C over the window, Dim*window square; its selection changes
  Eigen::VectorXd added_stiffness;          ///< see ContactBlockInput, Dim*window, or empty
  bool test_stability = false;              ///< see ContactBlockInput
  Eigen::VectorXd free_increment;           ///< (K^-1(-R)) on the window [length]
  const Eigen::VectorXd* u = nullptr;       ///< displacement at the linearization point, num_dofs
  const Eigen::VectorXd* R = nullptr;       ///< residual force there, num_dofs
  EntryPlaces<Dim>* entry = nullptr;
  bool adapt = true; ///< false: states stay as they are (event stepping)
  ActiveSetOptions options;
  GeometricTerms terms = GeometricTerms::COMPLETE;
  FrictionTangent friction_tangent = FrictionTangent::CONSISTENT;
};

template <int Dim> struct WindowSolution {
  bool singular = false, unstable = false; ///< see ContactBlockSolution
  int weakest_coordinate = -1;
  int passes = 0;
  ContactState<Dim> state; ///< states, places moved by the slips, q + dq
  std::vector<char> fresh; ///< per candidate: came into contact in this call
  Eigen::VectorXd F;       ///< contact force on the window, Dim*window [force]
  Eigen::VectorXd load;    ///< F plus what the added stiffness carries, the load of the factor [force]
};

/// Solves the block, tests every window node, changes states and repeats until nothing changes.
/// A sticking node with N < 0 first slides; only a sliding node is released (METHOD.md 5.4).
template <int Dim>
WindowSolution<Dim> solve_window(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                 const PrescribedValues& prescribed, const ContactState<Dim>& state,
                                 const WindowProblem<Dim>& problem);

/// Tests one candidate and changes its state.
/// @param solved its place after the increment; @param F force of the tool on it then, of a free one zero [force]
/// @param x      its position then [length]; @param poses of the tools then
/// @param node   state that the increment was made with; changed
/// @param deciding force by which its stick and slip are decided; a tied node is only released
/// @returns whether it changed
template <int Dim>
bool test_node(const ContactModel<Dim>& model, int candidate, const std::vector<Pose<Dim>>& poses,
               const ContactNode<Dim>& solved, const Vector<Dim>& F, const DecidingForce<Dim>& deciding,
               const Vector<Dim>& x, EntryPlaces<Dim>& entry, const ActiveSetOptions& options,
               ContactNode<Dim>& node);

} // namespace burnish

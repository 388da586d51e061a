#pragma once
// The dense block of the window at fixed contact states, and one pass of tests of its solution (ALGORITHMS.md 5.3).
#include "contact/body_view.hpp"
#include "contact/contact_block.hpp"
#include "contact/node_test.hpp"

namespace burnish {

/// One linear contact problem: the window of candidates that the factor keeps, and the increment without
/// contact.
template <int Dim> struct WindowProblem {
  const ContactModel<Dim>* model = nullptr;
  const BodyView<Dim>* body = nullptr;
  const PrescribedValues* prescribed = nullptr;
  const ContactState<Dim>* start = nullptr; ///< at the linearization point
  const Eigen::VectorXd* resting =
      nullptr; ///< where coordinates that nothing resists stay; null: where they are at the start
  const std::vector<int>* window = nullptr; ///< candidate numbers (index into ContactModel::candidates)
  ActivePart* flexibility = nullptr;        ///< C over the window, Dim*window square; its selection changes
  Eigen::VectorXd added_stiffness;          ///< see ContactBlockInput, Dim*window, or empty
  bool test_stability = false;              ///< see ContactBlockInput
  Eigen::VectorXd free_increment;           ///< (K^-1(-R)) on the window [length]
  const Eigen::VectorXd* u = nullptr;       ///< displacement at the linearization point, num_dofs
  const Eigen::VectorXd* R = nullptr;       ///< residual force there, num_dofs
  EntryPlaces<Dim>* entry = nullptr;
  int iteration = 0;     ///< number in its step
  bool adapt = true;     ///< false: states stay as they are (event stepping)
  Tolerances tolerances; ///< of the state tests
  int max_passes = 100;  ///< over the window
  GeometricTerms terms = GeometricTerms::COMPLETE;
  FrictionTangent friction_tangent = FrictionTangent::CONSISTENT;
};

template <int Dim> struct WindowSolution {
  bool singular = false, unstable = false; ///< see ContactBlockSolution
  bool indefinite =
      false; ///< singular, since a part of the flexibility is not positive definite: the body is not
  int weakest_coordinate = -1;
  bool held_back = false; ///< a coordinate that runs away was kept at its place (METHOD.md 5.5)
  int passes = 0;
  bool stopped = false; ///< the run shall end (stop_asked): no solution
  int left = 0; ///< states that contradict the forces in the last pass; 0: it is a solution of the window
  ContactState<Dim> state; ///< states, places moved by the slips, q + dq
  Eigen::VectorXd F;       ///< contact force on the window, Dim*window [force]
  Eigen::VectorXd load;    ///< F plus what the added stiffness carries, the load of the factor [force]
};

template <int Dim> class WindowSolver {
public:
  /// @param problem must outlive it
  explicit WindowSolver(const WindowProblem<Dim>& problem);
  /// Tools that friction alone holds, whose turning directions resist (METHOD.md 5.5); none in the first iteration of a
  /// step. Empty in the plane.
  const std::vector<char>& turning() const { return m_turning; }
  /// Solves with the states of the trial. @returns false if it cannot be done; out tells why, and keeps its passes
  bool solve(const ContactState<Dim>& trial, WindowSolution<Dim>& out) const;
  /// Tests every node of the window. @param trial the states that were solved with; changed
  /// @param severity per candidate [length]: tension of a node in contact times its own flexibility along the
  /// normal, or penetration of a free one
  /// @returns the number of changes
  int test(const WindowSolution<Dim>& solution, ContactState<Dim>& trial,
           std::vector<double>& severity) const;
  /// After a pass: nodes that it has released come back, if they do, without the force that they had at the start.
  void note_released(const ContactState<Dim>& before, const ContactState<Dim>& after);
  /// From now on coordinates that run away are not held back (WindowSolution::held_back).
  void let_run() { m_lets_run = true; }

private:
  std::vector<int> active_positions(const ContactState<Dim>& trial) const;
  std::vector<NodeLinearization<Dim>>
  linearize(const ContactState<Dim>& trial, const std::vector<int>& active, Eigen::VectorXd& offset) const;
  ContactBlockSolution<Dim> solved_with_idle(PrescribedValues& prescribed,
                                             const ContactBlockInput<Dim>& input, bool& held_back) const;
  template <class Force>
  std::vector<DecidingForce<Dim>> deciding_at(const ContactState<Dim>& state,
                                              const std::vector<Pose<Dim>>& poses,
                                              const std::vector<int>& active, const Force& force) const;

  const WindowProblem<Dim>& m_problem;
  const ContactModel<Dim>& m_model;
  const BodyView<Dim>& m_body;
  const std::vector<int>& m_window;
  std::vector<char> m_released;               // per candidate, by a pass, in space
  std::vector<char> m_by_friction, m_turning; // per tool, in space; empty: states stay
  bool m_lets_run = false;                    // let_run
};

} // namespace burnish

#pragma once
// The accepted end of a step as the observers of a run see it.
#include "contact/contact_setup.hpp"
#include "contact/tied_edges.hpp"
#include "workpiece/workpiece.hpp"

namespace burnish {

/// A node in contact, with what its tool exerts on it.
template <int Dim> struct CheckedNode {
  int candidate = -1;
  ContactPoint<Dim> at;        ///< of its tool
  NodalForce<Dim> force;       ///< of the tool on the node [force]
  DecidingForce<Dim> deciding; ///< by which its stick and slip are decided
  Vector<Dim> x;               ///< where the node is [length]
};

/// What the step was held to.
struct StepTolerance {
  double load = 0;     ///< that of the tolerance [force]
  double relative = 0; ///< tolerance of the residual over the load
  double rounding = 0; ///< residual that rounding leaves [force]
  double offset = 0;   ///< distance of a contact node from its tool that does not count [length]
  double residual() const { return relative * load; }
};

/// The soft hold of the body, see cxx/run/hold.hpp.
struct SeenHold {
  Eigen::VectorXd force{}; ///< on the nodes, num_dofs; empty: none [force]
  double share = 0;        ///< what it carries or carried when it ended, over the load [-]
  double until = 0;        ///< when it ends or ended [time]
};

/// Refers to what belongs to the run.
template <int Dim> struct AcceptedStep {
  const ContactSetup<Dim>& setup;
  const ContactState<Dim>& contact;
  const Eigen::VectorXd &u, &R; ///< displacement [length], internal minus external nodal force [force]
  const Eigen::VectorXd& generalized_force;  ///< on the tools [force, force length]
  const Workpiece<Dim>* workpiece = nullptr; ///< null: the forms of a script, of which nothing is known
  SeenHold hold{};
  double jumped = 0, drives = 0; ///< dissipated by jumps, work of the tools, of the run so far [force length]
  StepTolerance allowed{};
  double t = 0, dt = 0;                         ///< its end and its length [time]
  bool last = false;                            ///< the program is at its end
  const PrescribedValues* prescribed = nullptr; ///< at its end; null before the first step
  std::size_t window = 0;                       ///< candidates on the dense block of its factor
  // set by prepare
  long number = 0; ///< of the steps looked at, from 1; 0: the start of the run
  std::vector<Pose<Dim>> poses{};
  std::vector<CheckedNode<Dim>> touching{}; ///< nodes in contact
  Eigen::VectorXd internal{};               ///< internal nodal force; empty without a workpiece [force]

  const Mesh<Dim>& mesh() const { return setup.mesh(); }
  const ContactModel<Dim>& model() const { return setup.model(); }
  const BodyView<Dim>& body() const { return setup.body(); }
  std::string tool_name(int tool) const { return model().tools[tool]->name(); }
  std::vector<double> place_of(const Vector<Dim>& x) const { return {x.data(), x.data() + Dim}; }
  /// Fields are looked at in every SELDOM-th step, or the first of so many, and in the last.
  bool tenth() const { return number % SELDOM == 0 || last; }
  bool first_of_ten() const { return (number - 1) % SELDOM == 0 || last; }
  static constexpr int SELDOM = 10;
  /// Where quadrature point p is now [length].
  Vector<Dim> point(int p) const;
  /// " at x y, t = ..." of a finding.
  std::string at(const Vector<Dim>& x) const;
};

/// Computes poses, nodes in contact and, for the checks, the internal force.
template <int Dim> void prepare(AcceptedStep<Dim>& step, long number, bool checks);

} // namespace burnish

#pragma once
// The accepted end of a step as the self-checks of a run see it.
#include "contact/body_view.hpp"
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

/// Refers to what belongs to the run.
template <int Dim> struct AcceptedStep {
  const Workpiece<Dim>& workpiece;
  const Mesh<Dim>& mesh;
  const std::vector<Facet<Dim>>& surface; ///< of the contact
  const ContactModel<Dim>& model;
  const BodyView<Dim>& body;
  const ContactState<Dim>& contact;
  const Eigen::VectorXd &u, &R; ///< displacement [length], internal minus external nodal force [force]
  const Eigen::VectorXd& generalized_force; ///< on the tools [force, force length]
  Eigen::VectorXd hold{}; ///< force of the soft hold on the nodes, num_dofs; empty: none [force]
  double load = 0;        ///< that of the tolerance [force]
  double tolerance = 0;   ///< of the residual over the load
  double t = 0, dt = 0;   ///< its end and its length [time]
  bool last = false;      ///< the program is at its end
  const PrescribedValues* prescribed = nullptr; ///< at its end; null before the first step
  std::size_t window = 0;                       ///< candidates on the dense block of its factor
  // set by prepare
  std::vector<Pose<Dim>> poses{};
  std::vector<CheckedNode<Dim>> touching{}; ///< nodes in contact
  Eigen::VectorXd internal{};               ///< internal nodal force [force]

  std::string tool_name(int tool) const { return model.tools[tool]->name(); }
  std::vector<double> place_of(const Vector<Dim>& x) const { return {x.data(), x.data() + Dim}; }
  /// Where quadrature point p is now [length].
  Vector<Dim> point(int p) const;
  /// " at x y, t = ..." of a finding.
  std::string at(const Vector<Dim>& x) const;
};

/// Computes poses, nodes in contact and internal force.
template <int Dim> void prepare(AcceptedStep<Dim>& step);

} // namespace burnish

#pragma once
// Forces and moments on the workpiece in the accepted state of a run, and whether they balance (METHOD.md 3.14).
#include "contact/resultant.hpp"
#include "run/contact_run.hpp"

namespace burnish {

/// All of the accepted state, about one point; axisymmetric: of the whole ring, only the axial force counts.
template <int Dim> class ForceBalance {
public:
  /// @param run   must outlive it
  /// @param about the point of the moments, in the present configuration [length]
  /// @throws std::invalid_argument if it is not finite
  ForceBalance(const ContactRun<Dim>& run, const Vector<Dim>& about);

  /// Force of the supports on the workpiece. @param nodes only those of these; empty: all
  Resultant<Dim> reaction(const std::vector<int>& nodes = {}) const;
  /// Force of a tool on the workpiece. @param tool -1: of all tools
  Resultant<Dim> contact_force(int tool) const;
  /// Force of what the script puts on the nodes: weight, pressure.
  /// @param internal internal nodal force of the accepted state, num_dofs [force]
  Resultant<Dim> external_force(const Eigen::VectorXd& internal) const;
  /// Force of the soft hold on the workpiece.
  Resultant<Dim> hold_force() const;
  /// What is out of balance: the largest component of the sum of all forces over the load, or of their moment over load
  /// and size of the body (largest distance of a node from the middle) [-]; 0 without any force.
  double imbalance(const Eigen::VectorXd& internal) const;

private:
  Eigen::VectorXd hold_forces() const;
  Resultant<Dim> sum(const Eigen::VectorXd& f, const Vector<Dim>& about,
                     const std::vector<int>& nodes = {}) const;

  const ContactRun<Dim>& m_run;
  Vector<Dim> m_about;
};

} // namespace burnish

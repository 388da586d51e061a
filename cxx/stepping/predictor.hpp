#pragma once
// Predicted state of a step: the last step's increment and contact states carried along with the tools
// (algorithms.md section 3).
#include "mesh/discretization.hpp"
#include "stepping/balance.hpp"

namespace burnish {

/// Finds the element of a reference position by walking from a neighbor.
template <int Dim> class MeshLocator {
public:
  explicit MeshLocator(const Discretization<Dim>& discretization);
  /// Element that contains P, or the boundary element reached when P lies outside by at most `slack` in
  /// barycentric coordinates; -1 otherwise. Walks from an element at mesh node `near`.
  int find(const Vector<Dim>& P, int near, double slack = 0.2) const;
  /// Values of the shape functions of an element at P (its nodes_per_element entries).
  void shape(int element, const Vector<Dim>& P, double* N) const;

private:
  Eigen::Matrix<double, Dim + 1, 1> barycentric(int element, const Vector<Dim>& P) const;
  const Discretization<Dim>* m_d;
  std::vector<int> m_neighbor; // per element and vertex: element across the opposite face, -1 at the boundary
  std::vector<int> m_any_element; // per node
};

/// The step before: what the predictor carries on. Plain data.
template <int Dim> struct StepHistory {
  Eigen::VectorXd du;    ///< displacement increment of the last step, empty before the first
  Eigen::VectorXd dq;    ///< increment of the coordinates
  Eigen::VectorXd q_old; ///< coordinates at its start
  double dt = 0;
};

template <int Dim> struct Prediction {
  Eigen::VectorXd u;
  ContactState<Dim> state;
  std::vector<ContactNode<Dim>> entry; ///< per candidate, where a node touching in this step would stick
};

/// @param state, u accepted state at the start of the step; slips are counted from here
/// @param carry_states also carry the contact states along (false: states stay, event stepping)
template <int Dim>
Prediction<Dim> predict(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                        const MeshLocator<Dim>& locator, const Discretization<Dim>& discretization,
                        const Program& program, const ContactState<Dim>& state, const Eigen::VectorXd& u,
                        const StepHistory<Dim>& history, double dt, bool carry_states);

} // namespace burnish

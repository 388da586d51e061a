#pragma once
// Predicted state of a step: the last step's increment and contact states carried along with the tools
// (algorithms.md section 3).
#include "mesh/mesh_locator.hpp"
#include "stepping/balance.hpp"

namespace burnish {

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
                        const MeshLocator<Dim>& locator, const Mesh<Dim>& mesh, const Program& program,
                        const ContactState<Dim>& state, const Eigen::VectorXd& u,
                        const StepHistory<Dim>& history, double dt, bool carry_states);

} // namespace burnish

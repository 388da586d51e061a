#include "iteration/factored_tangent.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {
namespace {

// Stiffness as large as the mean of its own diagonal for some nodes, the same in all directions, Dim*window.
template <int Dim>
Eigen::VectorXd stiffness_of_contact(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                     const ContactState<Dim>& state, const std::vector<int>& window,
                                     const NodeBlockMatrix<Dim>& K) {
  Eigen::VectorXd added = Eigen::VectorXd::Zero(Dim * static_cast<Eigen::Index>(window.size()));
  for (std::size_t w = 0; w < window.size(); ++w) {
    const bool end = w == 0 || w + 1 == window.size();
    if (!end && !in_contact(state.nodes[window[w]].state)) continue;
    const int node = model.candidates[window[w]];
    const double* block = K.block(K.find(node, node));
    const double mean = std::abs(Eigen::Map<const Eigen::Matrix<double, Dim, Dim>>(block).trace()) / Dim;
    for (int c = 0; c < Dim; ++c)
      if (!body.fixed[Dim * node + c]) added[Dim * static_cast<Eigen::Index>(w) + c] = mean;
  }
  return added;
}

} // namespace

template <int Dim>
FactorStatus FactoredTangent<Dim>::factorize(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                             const ContactState<Dim>& state, NodeBlockMatrix<Dim> K,
                                             bool stiffen) {
  std::vector<int> nodes;
  for (const int i : window) nodes.push_back(model.candidates[i]);
  solver->analyze(K, body.fixed, nodes);
  added_stiffness.resize(0);
  if (stiffen) added_stiffness = stiffness_of_contact(model, body, state, window, K);
  return solver->factorize(std::move(K), added_stiffness);
}

template <int Dim>
void FactoredTangent<Dim>::factorize_again(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                           std::unique_ptr<BodySolver<Dim>> by) {
  solver = std::move(by);
  std::vector<int> nodes;
  for (const int i : window) nodes.push_back(model.candidates[i]);
  solver->analyze(matrix, body.fixed, nodes);
  if (solver->factorize(matrix, added_stiffness) != FactorStatus::OK)
    fail("contact", "the factor of the state's tangent cannot be made again");
  solver->solve_columns(solved);
}

template <int Dim> void FactoredTangent<Dim>::condense() {
  flexibility = std::make_shared<Eigen::MatrixXd>(solver->candidate_flexibility());
}

template struct FactoredTangent<2>;
template struct FactoredTangent<3>;

} // namespace burnish

#include "stepping/factored_tangent.hpp"
#include <cmath>

namespace burnish {
namespace {

// K with stiffness as large as its own on the diagonal of some nodes; sets `added`.
template <int Dim>
NodeBlockMatrix<Dim> stiffened(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                               const ContactState<Dim>& state, const std::vector<int>& window,
                               const NodeBlockMatrix<Dim>& K, Eigen::VectorXd& added) {
  NodeBlockMatrix<Dim> result = K;
  added = Eigen::VectorXd::Zero(Dim * static_cast<Eigen::Index>(window.size()));
  for (std::size_t w = 0; w < window.size(); ++w) {
    const bool end = w == 0 || w + 1 == window.size();
    if (!end && !in_contact(state.nodes[window[w]].state)) continue;
    const int node = model.candidates[window[w]];
    double* block = result.block(result.find(node, node));
    for (int c = 0; c < Dim; ++c) {
      if (body.fixed[Dim * node + c]) continue;
      const double stiffness = std::abs(block[c * Dim + c]);
      added[Dim * static_cast<Eigen::Index>(w) + c] = stiffness;
      block[c * Dim + c] += stiffness;
    }
  }
  return result;
}

} // namespace

template <int Dim>
FactorStatus FactoredTangent<Dim>::factorize(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                             const ContactState<Dim>& state, const NodeBlockMatrix<Dim>& K,
                                             bool stiffen) {
  std::vector<int> nodes;
  for (const int i : window) nodes.push_back(model.candidates[i]);
  solver->analyze(K, body.fixed, nodes);
  added_stiffness.resize(0);
  if (stiffen) return solver->factorize(stiffened(model, body, state, window, K, added_stiffness));
  return solver->factorize(K);
}

template <int Dim> void FactoredTangent<Dim>::condense() {
  flexibility = std::make_shared<const Eigen::MatrixXd>(solver->candidate_flexibility());
}

template struct FactoredTangent<2>;
template struct FactoredTangent<3>;

} // namespace burnish

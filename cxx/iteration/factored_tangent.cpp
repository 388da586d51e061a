#include "iteration/factored_tangent.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double ALIKE =
    1 + 1e-9; // places as far away as another: the first one is taken, whatever the rounding

template <int Dim>
Vector<Dim> place_of(const ContactModel<Dim>& model, const BodyView<Dim>& body, int candidate) {
  return body.X.template segment<Dim>(Eigen::Index{Dim} * model.candidates[candidate]);
}

// Stiffness as large as the mean of its own diagonal for some nodes, the same in all directions, Dim*window.
template <int Dim>
Eigen::VectorXd stiffness_of_contact(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                     const ContactState<Dim>& state, const std::vector<int>& window,
                                     const NodeBlockMatrix<Dim>& K) {
  Eigen::VectorXd added = Eigen::VectorXd::Zero(Dim * static_cast<Eigen::Index>(window.size()));
  const std::vector<int> far = far_candidates(model, body);
  for (std::size_t w = 0; w < window.size(); ++w) {
    const bool is_far = std::binary_search(far.begin(), far.end(), window[w]);
    if (!is_far && !in_contact(state.nodes[window[w]].state)) continue;
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
std::vector<int> far_candidates(const ContactModel<Dim>& model, const BodyView<Dim>& body) {
  const int count = static_cast<int>(model.candidates.size());
  Vector<Dim> middle = Vector<Dim>::Zero();
  for (int i = 0; i < count; ++i) middle += place_of(model, body, i) / count;
  std::vector<int> far;
  for (int found = 0; found < Dim;
       ++found) { // the next one is farthest from the middle, the first, their line
    const Vector<Dim> from = far.empty() ? middle : place_of(model, body, far[0]);
    Vector<Dim> along = Vector<Dim>::Zero();
    if (found == 2) along = (place_of(model, body, far[1]) - from).normalized();
    double largest = 0;
    int best = 0;
    for (int i = 0; i < count; ++i) {
      const Vector<Dim> r = place_of(model, body, i) - from;
      const double distance = (r - r.dot(along) * along).norm();
      if (distance > ALIKE * largest) {
        largest = distance;
        best = i;
      }
    }
    far.push_back(best);
  }
  std::sort(far.begin(), far.end());
  far.erase(std::unique(far.begin(), far.end()), far.end());
  return far;
}

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
  condense();
}

template <int Dim> void FactoredTangent<Dim>::condense() { flexibility = solver->candidate_flexibility(); }

template std::vector<int> far_candidates<2>(const ContactModel<2>&, const BodyView<2>&);
template std::vector<int> far_candidates<3>(const ContactModel<3>&, const BodyView<3>&);
template struct FactoredTangent<2>;
template struct FactoredTangent<3>;

} // namespace burnish

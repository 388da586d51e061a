#include "contact/corner_shares.hpp"
#include "mesh/simplex.hpp"
#include <algorithm>

namespace burnish {

// Mid nodes with the ends of their edges, each once.
template <int Dim> void CornerShares<Dim>::find_middles(const std::vector<std::vector<int>>& facets) {
  std::vector<char> known(m_number.size(), 0);
  for (const std::vector<int>& nodes : facets)
    for (int e = 0; e < num_edges<Dim - 1>; ++e) {
      const int middle = nodes[static_cast<std::size_t>(Dim + e)];
      if (middle < 0 || known[middle]) continue;
      known[middle] = 1;
      const auto [a, b] = SimplexEdges<Dim - 1>::ends[e];
      m_middles.push_back({middle, {nodes[a], nodes[b]}, {0, 0}});
    }
}

template <int Dim> void CornerShares<Dim>::find_small(const Eigen::VectorXd& area) {
  for (const Middle& middle : m_middles)
    for (const int end : middle.end)
      if (end >= 0 && area[end] < OWN_AREA * area[middle.node]) m_small[end] = 1;
  for (const Middle& middle : m_middles) // judged by the smallest of its mid nodes
    for (const int end : middle.end)
      if (end >= 0 && !(area[end] < OWN_AREA * area[middle.node])) m_small[end] = 0;
}

template <int Dim> void CornerShares<Dim>::choose_corners(const ContactState<Dim>& state) {
  const auto touches = [&](int i) { return i >= 0 && in_contact(state.nodes[i].state); };
  const auto add = [&](int i) {
    if (i < 0 || m_number[i] >= 0) return;
    m_number[i] = static_cast<int>(m_corners.size());
    m_corners.push_back(i);
  };
  for (const Middle& middle : m_middles) {
    const auto [a, b] = middle.end;
    for (const int end : {a, b})
      if (touches(end) || (end >= 0 && m_small[end] && touches(middle.node))) add(end);
    if (touches(middle.node) && !touches(a) && !touches(b)) {
      add(a);
      add(b);
    }
  }
  for (Middle& middle : m_middles) {
    std::array<bool, 2> corner;
    for (int e = 0; e < 2; ++e) corner[e] = middle.end[e] >= 0 && m_number[middle.end[e]] >= 0;
    for (int e = 0; e < 2; ++e) middle.weight[e] = corner[e] ? (corner[1 - e] ? 0.5 : 1) : 0;
  }
}

template <int Dim>
CornerShares<Dim>::CornerShares(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                const ContactState<Dim>& state, const std::vector<Facet<Dim>>& facets,
                                const Eigen::VectorXd& u, const Eigen::VectorXd& area) {
  const std::vector<int> candidate =
      candidate_of_node(model.candidates, static_cast<int>(body.X.size()) / Dim);
  m_number.assign(state.nodes.size(), -1);
  m_small.assign(state.nodes.size(), 0);
  m_reported.assign(state.nodes.size(), 0);
  std::vector<std::vector<int>> quadratic;
  std::vector<Eigen::MatrixXd> masses;
  for (const Facet<Dim>& facet : facets) {
    if (facet.middle[0] < 0) continue;
    quadratic.emplace_back();
    for (const int node : nodes_of(facet)) quadratic.back().push_back(candidate[node]);
    masses.push_back(body.measure->masses(places_of(body, facet, u)));
  }
  find_middles(quadratic);
  find_small(area);
  choose_corners(state);
  if (empty()) return;
  m_areas = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_corners.size()));
  for (std::size_t f = 0; f < quadratic.size(); ++f) {
    const std::vector<int>& nodes = quadratic[f];
    const Eigen::RowVectorXd part = masses[f].colwise().sum();
    double beside = 0; // of vertices that are no candidates
    for (int v = 0; v < Dim; ++v) beside += nodes[v] < 0 ? part[v] : 0;
    for (int v = 0; v < Dim; ++v) {
      if (nodes[v] < 0 || m_number[nodes[v]] < 0) continue;
      m_areas[m_number[nodes[v]]] += part[v] + beside;
      for (const int i : nodes)
        if (i >= 0) m_reported[i] = 1;
    }
  }
}

template <int Dim> Eigen::VectorXd CornerShares<Dim>::shared(const Eigen::VectorXd& force) const {
  Eigen::VectorXd shares(static_cast<Eigen::Index>(m_corners.size()));
  for (std::size_t c = 0; c < m_corners.size(); ++c)
    shares[static_cast<Eigen::Index>(c)] = force[m_corners[c]];
  for (const Middle& middle : m_middles)
    for (int e = 0; e < 2; ++e)
      if (middle.weight[e] > 0) shares[m_number[middle.end[e]]] += middle.weight[e] * force[middle.node];
  return shares;
}

template <int Dim>
Eigen::VectorXd CornerShares<Dim>::traction(const Eigen::VectorXd& force, Eigen::VectorXd nodal) const {
  const Eigen::VectorXd values = shared(force).cwiseQuotient(m_areas);
  for (std::size_t i = 0; i < m_number.size(); ++i)
    if (m_reported[i]) nodal[static_cast<Eigen::Index>(i)] = m_number[i] < 0 ? 0 : values[m_number[i]];
  for (const Middle& middle : m_middles) {
    if (!m_reported[middle.node]) continue;
    const auto [a, b] = middle.end; // one that is no candidate has the value of the other
    nodal[middle.node] = 0.5 * (nodal[a < 0 ? b : a] + nodal[b < 0 ? a : b]);
  }
  return nodal;
}

template class CornerShares<2>;
template class CornerShares<3>;

} // namespace burnish

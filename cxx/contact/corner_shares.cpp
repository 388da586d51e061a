#include "contact/facet_fit.hpp"
#include "mesh/simplex.hpp"
#include <algorithm>

namespace burnish {

template <int Dim>
FacetFit<Dim>::FacetFit(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                        const ContactState<Dim>& state, const std::vector<Facet<Dim>>& facets,
                        const Eigen::VectorXd& u, const Eigen::VectorXd& area) {
  const std::vector<int> candidate = model.candidate_of_node(static_cast<int>(body.X.size()) / Dim);
  const double least = area.size() ? NO_AREA * area.maxCoeff() : 0;
  m_row.assign(state.nodes.size(), -1);
  m_column = m_row;
  const auto number = [](int i, std::vector<int>& of, std::vector<int>& list) {
    if (of[i] >= 0) return;
    of[i] = static_cast<int>(list.size());
    list.push_back(i);
  };
  const auto touches = [&](int i) { return in_contact(state.nodes[i].state); };
  for (const Facet<Dim>& facet : facets) {
    if (facet.middle[0] < 0) continue;
    Quadratic quadratic;
    for (const int node : nodes_of(facet)) quadratic.nodes.push_back(candidate[node]);
    const auto& nodes = quadratic.nodes;
    if (*std::min_element(nodes.begin(), nodes.end()) < 0) continue;
    if (std::none_of(nodes.begin(), nodes.end(), touches)) continue;
    for (const int i : nodes) number(i, m_row, m_nodes);
    for (int v = 0; v < Dim; ++v)
      if (touches(nodes[v]) || area[nodes[v]] <= least) number(nodes[v], m_column, m_vertices);
    quadratic.mass = body.measure->masses(places_of(body, facet, u));
    m_facets.push_back(std::move(quadratic));
  }
  if (empty()) return;
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& facet : m_facets)
    for (int v = 0; v < Dim; ++v)
      for (std::size_t i = 0; i < facet.nodes.size() && m_column[facet.nodes[v]] >= 0; ++i)
        entries.emplace_back(m_row[facet.nodes[i]], m_column[facet.nodes[v]],
                             facet.mass(static_cast<int>(i), v));
  Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(m_nodes.size()),
                                     static_cast<Eigen::Index>(m_vertices.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  m_solver.compute(matrix);
}

template <int Dim>
Eigen::VectorXd FacetFit<Dim>::fit(const Eigen::VectorXd& force, Eigen::VectorXd nodal) const {
  Eigen::VectorXd right(static_cast<Eigen::Index>(m_nodes.size()));
  for (std::size_t r = 0; r < m_nodes.size(); ++r) right[static_cast<Eigen::Index>(r)] = force[m_nodes[r]];
  const Eigen::VectorXd values = m_solver.solve(right);
  for (std::size_t c = 0; c < m_vertices.size(); ++c)
    nodal[m_vertices[c]] = values[static_cast<Eigen::Index>(c)];
  for (const auto& facet : m_facets)
    for (int e = 0; e < num_edges<Dim - 1>; ++e) {
      const auto [a, b] = SimplexEdges<Dim - 1>::ends[e];
      nodal[facet.nodes[Dim + e]] = 0.5 * (nodal[facet.nodes[a]] + nodal[facet.nodes[b]]);
    }
  return nodal;
}

template class FacetFit<2>;
template class FacetFit<3>;

} // namespace burnish

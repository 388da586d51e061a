#include "contact/contact_setup.hpp"
#include "base/error.hpp"
#include "contact/coupling.hpp"
#include "contact/surface_curve.hpp"
#include "mesh/simplex.hpp"
#include <algorithm>
#include <set>

namespace burnish {
namespace {

constexpr double SPACING_OF_TOOL =
    1e-2; // spacing of a single candidate, over the length scale of the first tool

// See ContactModel::edge_ends.
template <int Dim>
std::vector<std::array<int, 2>> ends_of_edges(const std::vector<Facet<Dim>>& surface,
                                              const std::vector<int>& candidate) {
  std::vector<std::array<int, 2>> ends;
  for (const Facet<Dim>& facet : surface) {
    if (facet.middle[0] < 0) continue;
    if (ends.empty())
      ends.assign(static_cast<std::size_t>(
                      std::count_if(candidate.begin(), candidate.end(), [](int i) { return i >= 0; })),
                  {-1, -1});
    for (std::size_t e = 0; e < facet.middle.size(); ++e) {
      const auto& end = SimplexEdges<Dim - 1>::ends[e];
      const int a = candidate[facet.vertex[end[0]]], b = candidate[facet.vertex[end[1]]],
                m = candidate[facet.middle[e]];
      if (a >= 0 && b >= 0 && m >= 0) ends[m] = {a, b};
    }
  }
  return ends;
}

// See ContactModel::weightless.
template <int Dim>
std::vector<char> weightless_vertices(const std::vector<Facet<Dim>>& surface,
                                      const std::vector<int>& candidate, std::size_t candidates) {
  std::vector<char> weightless;
  for (const Facet<Dim>& facet : surface) {
    if (Dim == 2 || facet.middle[0] < 0) continue;
    weightless.resize(candidates, 0);
    for (const int vertex : facet.vertex)
      if (candidate[vertex] >= 0) weightless[static_cast<std::size_t>(candidate[vertex])] = 1;
  }
  return weightless;
}

// See ContactModel::neighbors. Vertices of quadratic facets have their mid nodes between them; those of a triangle are
// neighbors of one another.
template <int Dim>
std::vector<std::vector<int>> neighbors_along(const std::vector<Facet<Dim>>& surface,
                                              const std::vector<int>& candidate, std::size_t candidates) {
  std::vector<std::vector<int>> neighbors(candidates);
  const auto join = [&](int a, int b) {
    const int i = candidate[a], j = candidate[b];
    if (i < 0 || j < 0 || std::count(neighbors[i].begin(), neighbors[i].end(), j) > 0) return;
    neighbors[i].push_back(j);
    neighbors[j].push_back(i);
  };
  for (const Facet<Dim>& facet : surface)
    for (std::size_t e = 0; e < facet.middle.size(); ++e) {
      const auto& ends = SimplexEdges<Dim - 1>::ends[e];
      const int a = facet.vertex[ends[0]], b = facet.vertex[ends[1]], middle = facet.middle[e];
      if (middle < 0) {
        join(a, b);
      } else {
        join(a, middle);
        join(middle, b);
        if (e > 0) join(facet.middle[e - 1], middle);
        if (e > 1) join(facet.middle[0], middle);
      }
    }
  return neighbors;
}

} // namespace

template <int Dim>
ContactSetup<Dim>::ContactSetup(Mesh<Dim> mesh, std::vector<Facet<Dim>> surface, std::vector<char> fixed,
                                std::shared_ptr<const FacetMeasure<Dim>> measure)
    : m_mesh(std::move(mesh)), m_surface(std::move(surface)) {
  require_valid(m_mesh, "contact");
  require(static_cast<int>(fixed.size()) == m_mesh.num_dofs(), "contact", "number of fixed flags",
          fixed.size(), "one per degree of freedom");
  if (!measure) fail("contact", "no measure of the surface");
  for (const int node : nodes_along(m_surface)) {
    ConstrainedComponents<Dim> constrained;
    bool all = true;
    for (int c = 0; c < Dim; ++c) {
      constrained[c] = fixed[Dim * node + c];
      all = all && constrained[c];
    }
    if (all) continue;
    m_model.candidates.push_back(node);
    m_model.constrained.push_back(constrained);
  }
  require(!m_model.candidates.empty(), "contact", "number of candidate nodes", 0,
          "at least one node on the labels that is not fixed");
  const std::vector<int> candidate = candidate_of_node(m_model.candidates, m_mesh.num_nodes);
  m_model.neighbors = neighbors_along(m_surface, candidate, m_model.candidates.size());
  m_model.edge_ends = ends_of_edges(m_surface, candidate);
  m_model.weightless = weightless_vertices(m_surface, candidate, m_model.candidates.size());
  m_body.X = places_on_curve(m_mesh, m_surface);
  m_body.fixed = std::move(fixed);
  m_body.measure = std::move(measure);
  m_model.first.assign(1, 0);
}

template <int Dim> void ContactSetup<Dim>::place_surface(const Eigen::VectorXd& places) {
  if (m_closed) fail("contact", "places of the surface must be given before the first step");
  m_body.X = places_given(m_mesh, m_surface, places);
}

template <int Dim>
void ContactSetup<Dim>::add_tool(std::shared_ptr<DrivenTool<Dim>> tool,
                                 std::shared_ptr<const FrictionLaw> friction,
                                 const std::vector<Facet<Dim>>& reach) {
  if (m_closed) fail("contact.add", "tools must be added before the first step");
  tool->tool(); // throws without coordinates
  for (const auto& other : m_tools)
    if (other->name() == tool->name()) fail("contact.add", "tool \"" + tool->name() + "\" is already there");
  m_model.tools.push_back(tool->shared_tool());
  m_model.first.push_back(m_model.first.back() + static_cast<int>(tool->q().size()));
  m_tools.push_back(std::move(tool));
  m_model.laws.emplace_back(std::move(friction));
  std::set<long> labels;
  for (const Facet<Dim>& facet : reach) labels.insert(facet.label);
  m_reach.emplace_back(labels.begin(), labels.end());
  m_model.reach.push_back(reached(reach));
}

// Per candidate whether it is on the facets; empty without any: all are.
template <int Dim> std::vector<char> ContactSetup<Dim>::reached(const std::vector<Facet<Dim>>& facets) const {
  if (facets.empty()) return {};
  std::vector<char> nodes(m_mesh.num_nodes, 0), result;
  for (const Facet<Dim>& facet : facets)
    for (const int node : nodes_of(facet)) nodes[node] = 1;
  for (const int candidate : m_model.candidates) result.push_back(nodes[candidate]);
  return result;
}

template <int Dim> void ContactSetup<Dim>::take_tools(const ContactSetup& other) {
  if (m_closed || !m_tools.empty()) fail("contact", "tools are taken over by a contact without any");
  m_tools = other.m_tools;
  m_reach = other.m_reach;
  m_model.tools = other.m_model.tools;
  m_model.laws = other.m_model.laws;
  m_model.first = other.m_model.first;
  m_model.couplings = other.m_model.couplings;
  for (const std::vector<long>& labels : m_reach)
    m_model.reach.push_back(labels.empty() ? std::vector<char>()
                                           : reached(facets_with(m_mesh, labels, "contact")));
}

template <int Dim> void ContactSetup<Dim>::couple(const std::string& dependent, const std::string& text) {
  if (m_closed) fail("contact.couple", "relations must be given before the first step and approach");
  Coupling coupling = make_coupling(m_model, dependent, text);
  const int tool = m_model.tool_of(coupling.dependent), k = coupling.dependent - m_model.first[tool];
  Prescription& prescription = m_tools[static_cast<std::size_t>(tool)]->prescription();
  prescription.follow(prescription.names()[static_cast<std::size_t>(k)], text);
  m_model.couplings.push_back(std::move(coupling));
}

template <int Dim> void ContactSetup<Dim>::close() {
  if (m_closed) return;
  require(!m_tools.empty(), "contact", "number of tools", 0, "at least one tool");
  m_body.spacing = candidate_spacing<Dim>(m_body.X, m_model.candidates);
  if (m_body.spacing == 0) m_body.spacing = m_model.tools[0]->surface().length_scale() * SPACING_OF_TOOL;
  m_closed = true;
}

template <int Dim> Eigen::VectorXd ContactSetup<Dim>::placed() const {
  Eigen::VectorXd q(m_model.num_coordinates());
  for (std::size_t t = 0; t < m_tools.size(); ++t)
    q.segment(m_model.first[t], m_tools[t]->q().size()) = m_tools[t]->q();
  return q;
}

template class ContactSetup<2>;
template class ContactSetup<3>;

} // namespace burnish

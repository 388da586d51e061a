#include "mesh/mesh.hpp"
#include "base/error.hpp"
#include "mesh/simplex.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace burnish {
namespace {

/// A radius may be negative by this fraction of the largest coordinate: rounding.
constexpr double RADIUS_ROUNDING = 1e-12;
/// Share of inverted elements from which the mesh as a whole is mirrored.
constexpr double MIRRORED = 0.9;

template <int Dim> void check_nodes(const Mesh<Dim>& mesh, const char* where) {
  require(mesh.X.size() == static_cast<std::size_t>(Dim) * mesh.num_nodes, where, "size of X", mesh.X.size(),
          "num_nodes x Dim");
  for (std::size_t k = 0; k < mesh.X.size(); ++k) {
    if (std::isfinite(mesh.X[k])) continue;
    std::ostringstream what;
    what << "X of node " << k / Dim << ", component " << k % Dim << " = " << mesh.X[k]
         << ", expected a finite number";
    fail(where, what.str());
  }
}

template <int Dim> void check_elements(const Mesh<Dim>& mesh, const char* where) {
  require(!mesh.connectivity.empty() && mesh.connectivity.size() % mesh.nodes_per_element == 0, where,
          "size of connectivity", mesh.connectivity.size(), "a positive multiple of nodes_per_element");
  require(mesh.connectivity.size() == static_cast<std::size_t>(mesh.num_elements) * mesh.nodes_per_element,
          where, "num_elements", mesh.num_elements, "size of connectivity over nodes_per_element");
  for (std::size_t k = 0; k < mesh.connectivity.size(); ++k) {
    const int node = mesh.connectivity[k];
    if (node >= 0 && node < mesh.num_nodes) continue;
    std::ostringstream what;
    what << "node of element " << k / mesh.nodes_per_element << " = " << node << ", expected 0 <= node < "
         << mesh.num_nodes;
    fail(where, what.str());
  }
  for (const Facet<Dim>& facet : mesh.facets)
    for (const int node : nodes_of(facet))
      require(node >= 0 && node < mesh.num_nodes, where, "node of a facet", node, "0 <= node < num_nodes");
}

std::string size_text(const Mesh<2>&, int e, double size) {
  std::ostringstream what;
  what << "area of element " << e << " = " << size << ", expected > 0 (vertices counter-clockwise)";
  return what.str();
}
std::string size_text(const Mesh<3>& mesh, int e, double size) {
  Vector<3> center = Vector<3>::Zero();
  for (int v = 0; v < 4; ++v) center += mesh.node(mesh.element(e)[v]) / 4;
  std::ostringstream what;
  what << "volume of element " << e << " at (" << center[0] << ", " << center[1] << ", " << center[2]
       << ") = " << size << ", expected > 0 (seen from vertex 3 the others are counter-clockwise)";
  return what.str();
}
/// What to do where so many elements are inverted that it is the map of the mesh; empty for fewer.
template <int Dim> std::string mirror_text(const Mesh<Dim>& mesh) {
  int inverted = 0;
  for (int e = 0; e < mesh.num_elements; ++e) inverted += signed_size(mesh, e) < 0 ? 1 : 0;
  if (inverted < MIRRORED * mesh.num_elements) return "";
  return "; " + std::to_string(inverted) + " of " + std::to_string(mesh.num_elements) +
         " elements are negative: the map of the mesh mirrors it, exchange two directions or change one sign";
}
template <int Dim> void check_sizes(const Mesh<Dim>& mesh, const char* where) {
  for (int e = 0; e < mesh.num_elements; ++e) {
    const double size = signed_size(mesh, e);
    if (!(size > 0)) fail(where, size_text(mesh, e, size) + mirror_text(mesh));
  }
}

template <int Dim> void check_radii(const Mesh<Dim>& mesh, const char* where) {
  double size = 0;
  for (const double x : mesh.X) size = std::max(size, std::abs(x));
  for (int a = 0; a < mesh.num_nodes; ++a) {
    if (mesh.node(a)[0] >= -RADIUS_ROUNDING * size) continue;
    std::ostringstream what;
    what << "x of node " << a << " = " << mesh.node(a)[0]
         << ", expected a radius >= 0 (axisymmetric: the axis is x = 0)";
    fail(where, what.str());
  }
}

/// Order of the nodes along chains of edges: from the free ends first, then closed chains.
class ChainWalk {
public:
  explicit ChainWalk(const std::vector<Facet<2>>& edges) : m_edges(edges), m_used(edges.size(), 0) {
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (const int end : edges[e].vertex) m_at[end].push_back(e);
  }
  std::vector<int> order() {
    for (const auto& [node, list] : m_at)
      if (list.size() == 1 && !m_used[list[0]]) walk(node);
    for (const auto& edge : m_edges) walk(edge.vertex[0]); // closed chains
    return m_order;
  }

private:
  void add(int node) {
    if (node >= 0 && m_seen.insert(node).second) m_order.push_back(node);
  }
  void walk(int node) {
    for (bool more = true; more;) {
      add(node);
      more = false;
      for (const std::size_t e : m_at[node]) {
        if (m_used[e]) continue;
        m_used[e] = 1;
        add(m_edges[e].middle[0]);
        node = m_edges[e].vertex[0] == node ? m_edges[e].vertex[1] : m_edges[e].vertex[0];
        more = true;
        break;
      }
    }
  }
  const std::vector<Facet<2>>& m_edges;
  std::vector<char> m_used;
  std::map<int, std::vector<std::size_t>> m_at; // edges of each end
  std::vector<int> m_order;
  std::set<int> m_seen;
};

} // namespace

template <> double signed_size(const Mesh<2>& mesh, int element) {
  const int* n = mesh.element(element);
  const Vector<2> a = mesh.node(n[1]) - mesh.node(n[0]), b = mesh.node(n[2]) - mesh.node(n[0]);
  return 0.5 * (a[0] * b[1] - a[1] * b[0]);
}
template <> double signed_size(const Mesh<3>& mesh, int element) {
  const int* n = mesh.element(element);
  const Vector<3> x = mesh.node(n[0]);
  return (mesh.node(n[1]) - x).cross(mesh.node(n[2]) - x).dot(mesh.node(n[3]) - x) / 6;
}

template <int Dim> void require_valid(const Mesh<Dim>& mesh, const char* where) {
  check_nodes(mesh, where);
  check_elements(mesh, where);
  if (mesh.axisymmetric) check_radii(mesh, where);
  check_sizes(mesh, where);
}

template <int Dim>
std::vector<Facet<Dim>> facets_with(const Mesh<Dim>& mesh, const std::vector<long>& labels,
                                    const char* where) {
  std::vector<Facet<Dim>> found;
  std::set<long> known;
  for (const Facet<Dim>& facet : mesh.facets) {
    known.insert(facet.label);
    if (std::find(labels.begin(), labels.end(), facet.label) != labels.end()) found.push_back(facet);
  }
  if (!found.empty()) return found;
  std::ostringstream text;
  text << "no boundary " << (Dim == 2 ? "edge" : "face") << " bears the label";
  for (const long label : labels) text << " " << label;
  text << "; the mesh has the labels";
  for (const long label : known) text << " " << label;
  fail(where, text.str());
}

template <int Dim> std::vector<int> nodes_along(const std::vector<Facet<Dim>>& facets) {
  std::vector<int> order;
  std::set<int> seen;
  for (const Facet<Dim>& facet : facets)
    for (const int node : nodes_of(facet))
      if (seen.insert(node).second) order.push_back(node);
  return order;
}
template <> std::vector<int> nodes_along<2>(const std::vector<Facet<2>>& facets) {
  return ChainWalk(facets).order();
}

template <int Dim> Facet<Dim> facet_opposite(const int* nodes, bool quadratic, int f) {
  static constexpr int opposite[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  std::array<int, Dim> corner;
  for (int v = 0; v < Dim; ++v) corner[v] = Dim == 2 ? (f + 1 + v) % 3 : opposite[f][v];
  const auto middle = [&](int a, int b) {
    for (int e = 0; quadratic && e < num_edges<Dim>; ++e)
      if (std::minmax(a, b) == std::minmax(SimplexEdges<Dim>::ends[e][0], SimplexEdges<Dim>::ends[e][1]))
        return nodes[Dim + 1 + e];
    return -1;
  };
  Facet<Dim> facet;
  for (int v = 0; v < Dim; ++v) facet.vertex[v] = nodes[corner[v]];
  for (int e = 0; e < num_edges<Dim - 1>; ++e)
    facet.middle[e] =
        middle(corner[SimplexEdges<Dim - 1>::ends[e][0]], corner[SimplexEdges<Dim - 1>::ends[e][1]]);
  return facet;
}

template Facet<2> facet_opposite<2>(const int*, bool, int);
template Facet<3> facet_opposite<3>(const int*, bool, int);
template void require_valid<2>(const Mesh<2>&, const char*);
template void require_valid<3>(const Mesh<3>&, const char*);
template std::vector<Facet<2>> facets_with<2>(const Mesh<2>&, const std::vector<long>&, const char*);
template std::vector<Facet<3>> facets_with<3>(const Mesh<3>&, const std::vector<long>&, const char*);
template std::vector<int> nodes_along<3>(const std::vector<Facet<3>>&);

} // namespace burnish

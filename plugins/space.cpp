// From a FreeFEM space to plain arrays.
#include "base/error.hpp"
#include "mesh/simplex.hpp"
#include "types.hpp"

namespace burnish {
namespace {

template <int Dim> const char* expected_space() {
  return Dim == 2 ? "the space must be [P1,P1] or [P2,P2]" : "the space must be [P1,P1,P1] or [P2,P2,P2]";
}

// Node numbers of element k: dof/Dim of the first component, in FreeFEM's local order (vertices, then
// mid-edges).
template <int Dim>
std::vector<int> element_nodes(const typename Freefem<Dim>::Space& V, int k, const char* where) {
  const auto K = V[k];
  const int dofs = K.NbDoF();
  constexpr int linear = Dim + 1, quadratic = linear + num_edges<Dim>;
  if (K.N != Dim || (dofs != Dim * linear && dofs != Dim * quadratic))
    fail(where, std::string(expected_space<Dim>()) + (Dim == 2 ? " on a 2D mesh" : " on tetrahedra"));
  std::vector<int> nodes;
  for (int a = 0; a < dofs / Dim; ++a) {
    if (K.DFOnWhat(a) != a) // P1nc, discontinuous spaces and others have their nodes elsewhere
      fail(where, std::string(expected_space<Dim>()) + ": nodes at vertices and mid-edges, continuous");
    for (int i = 0; i < Dim; ++i)
      if (K(a) % Dim != 0 || K(a + i * dofs / Dim) != K(a) + i)
        fail(where, std::string(expected_space<Dim>()) + ": the components of a node must be adjacent");
    nodes.push_back(K(a) / Dim);
  }
  return nodes;
}

template <int Dim>
const typename Freefem<Dim>::Space& space_of(typename Freefem<Dim>::Fespace* const& space,
                                             const char* where) {
  const auto* V = static_cast<typename Freefem<Dim>::Space*>(**space);
  if (!V) fail(where, "the fespace is empty");
  return *V;
}

int boundary_facets(const ::Mesh& Th) { return Th.neb; }
int boundary_facets(const ::Mesh3& Th) { return Th.nbe; }
Vector<2> place(const R2& P) { return {P.x, P.y}; }
Vector<3> place(const R3& P) { return {P.x, P.y, P.z}; }
double measure(const ::Triangle& K) { return K.area; }
double measure(const ::Fem2D::Tet& K) { return K.mesure(); }

// All boundary facets of the space's mesh, as nodes of the space.
template <int Dim>
std::vector<Facet<Dim>> facets_of(const typename Freefem<Dim>::Space& V, const char* where) {
  std::vector<Facet<Dim>> facets;
  for (int b = 0; b < boundary_facets(V.Th); ++b) {
    int f = 0;
    const int element = V.Th.BoundaryElement(b, f);
    const std::vector<int> nodes = element_nodes<Dim>(V, element, where);
    Facet<Dim> facet = facet_opposite<Dim>(nodes.data(), nodes.size() > Dim + 1, f);
    facet.element = element;
    facet.label = V.Th.be(b).lab;
    facets.push_back(facet);
  }
  return facets;
}

void refuse_periodic(int node, const std::string& here, const std::string& there, const char* where) {
  fail(where, "node " + std::to_string(node) + " is at (" + here + ") and at (" + there +
                  "), expected one place: periodic spaces are not supported");
}
template <int Dim> std::string text_of(const Vector<Dim>& x) {
  std::ostringstream text;
  for (int i = 0; i < Dim; ++i) text << (i > 0 ? ", " : "") << x[i];
  return text.str();
}

} // namespace

template <int Dim>
burnish::Mesh<Dim> mesh_of(typename Freefem<Dim>::Fespace* const& space, const char* where,
                           bool axisymmetric) {
  if (Dim == 3 && axisymmetric)
    fail(where, "axisymmetric=true belongs to a mesh of triangles, this one is in space");
  const auto& V = space_of<Dim>(space, where);
  const auto& Th = V.Th;
  burnish::Mesh<Dim> mesh;
  mesh.axisymmetric = axisymmetric;
  mesh.num_nodes = V.NbOfDF / Dim;
  mesh.num_elements = Th.nt;
  mesh.X.resize(V.NbOfDF);
  std::vector<char> placed(mesh.num_nodes, 0);
  for (int k = 0; k < Th.nt; ++k) {
    const std::vector<int> nodes = element_nodes<Dim>(V, k, where);
    mesh.nodes_per_element = static_cast<int>(nodes.size());
    mesh.connectivity.reserve(static_cast<std::size_t>(Th.nt) * nodes.size());
    mesh.connectivity.insert(mesh.connectivity.end(), nodes.begin(), nodes.end());
    const double size = std::pow(std::abs(measure(Th[k])), 1. / Dim);
    for (int a = 0; a < mesh.nodes_per_element; ++a) {
      Vector<Dim> P;
      if (a <= Dim) {
        P = place(Th[k][a]);
      } else {
        const auto [i, j] = SimplexEdges<Dim>::ends[a - Dim - 1];
        P = 0.5 * (place(Th[k][i]) + place(Th[k][j]));
      }
      Eigen::Map<Vector<Dim>> x(&mesh.X[Dim * nodes[a]]);
      if (placed[nodes[a]] && (x - P).norm() > 1e-6 * size)
        refuse_periodic(nodes[a], text_of<Dim>(x), text_of<Dim>(P), where);
      placed[nodes[a]] = 1;
      x = P;
    }
  }
  mesh.facets = facets_of<Dim>(V, where);
  return mesh;
}

template <int Dim>
std::shared_ptr<const typename Freefem<Dim>::Mesh> shared_mesh(typename Freefem<Dim>::Fespace* const& space,
                                                               const char* where) {
  const auto* mesh = &space_of<Dim>(space, where).Th;
  mesh->increment();
  return {mesh, [](const auto* shared) { shared->destroy(); }};
}

template burnish::Mesh<2> mesh_of<2>(pfes* const&, const char*, bool);
template burnish::Mesh<3> mesh_of<3>(pfes3* const&, const char*, bool);
template std::shared_ptr<const ::Mesh> shared_mesh<2>(pfes* const&, const char*);
template std::shared_ptr<const ::Mesh3> shared_mesh<3>(pfes3* const&, const char*);

} // namespace burnish

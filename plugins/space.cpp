// From a FreeFEM space to plain arrays.
#include "base/error.hpp"
#include "types.hpp"

namespace burnish {
namespace {

// Node numbers of element k: dof/2 of the first component, in FreeFEM's local order (vertices, then
// mid-edges).
std::vector<int> element_nodes(const FESpace& V, int k, const char* where) {
  const FElement K = V[k];
  const int dofs = K.NbDoF();
  if (K.N != 2 || (dofs != 6 && dofs != 12)) fail(where, "the space must be [P1,P1] or [P2,P2] on a 2D mesh");
  std::vector<int> nodes;
  for (int a = 0; a < dofs / 2; ++a) {
    if (K.DFOnWhat(a) != a) // P1nc, discontinuous spaces and others have their nodes elsewhere
      fail(where, "the space must be [P1,P1] or [P2,P2]: nodes at vertices and mid-edges, continuous");
    if (K(a) % 2 != 0 || K(a + dofs / 2) != K(a) + 1)
      fail(where, "the space must be [P1,P1] or [P2,P2]: the components of a node must be adjacent");
    nodes.push_back(K(a) / 2);
  }
  return nodes;
}

const FESpace& space_of(pfes* const& space, const char* where) {
  const FESpace* V = static_cast<FESpace*>(**space);
  if (!V) fail(where, "the fespace is empty");
  return *V;
}

// All boundary edges of the space's mesh, as nodes of the space.
std::vector<Facet<2>> edges_of(const FESpace& V, const char* where) {
  std::vector<Facet<2>> edges;
  for (int b = 0; b < V.Th.neb; ++b) {
    int e = 0;
    Facet<2> edge;
    edge.element = V.Th.BoundaryElement(b, e);
    edge.label = V.Th.be(b).lab;
    const std::vector<int> nodes = element_nodes(V, edge.element, where);
    edge.vertex = {nodes[(e + 1) % 3], nodes[(e + 2) % 3]};
    edge.middle = {nodes.size() == 6 ? nodes[3 + e] : -1};
    edges.push_back(edge);
  }
  return edges;
}

} // namespace

burnish::Mesh<2> mesh_of(pfes* const& space, const char* where, bool axisymmetric) {
  const FESpace& V = space_of(space, where);
  const ::Mesh& Th = V.Th;
  burnish::Mesh<2> mesh;
  mesh.axisymmetric = axisymmetric;
  mesh.num_nodes = V.NbOfDF / 2;
  mesh.num_elements = Th.nt;
  mesh.X.resize(V.NbOfDF);
  std::vector<char> placed(mesh.num_nodes, 0);
  for (int k = 0; k < Th.nt; ++k) {
    const std::vector<int> nodes = element_nodes(V, k, where);
    mesh.nodes_per_element = static_cast<int>(nodes.size());
    mesh.connectivity.reserve(static_cast<std::size_t>(Th.nt) * nodes.size());
    mesh.connectivity.insert(mesh.connectivity.end(), nodes.begin(), nodes.end());
    for (int a = 0; a < mesh.nodes_per_element; ++a) {
      const R2 P = a < 3 ? R2(Th[k][a]) : 0.5 * (R2(Th[k][(a - 2) % 3]) + R2(Th[k][(a - 1) % 3]));
      double* x = &mesh.X[2 * nodes[a]];
      if (placed[nodes[a]] &&
          (x[0] - P.x) * (x[0] - P.x) + (x[1] - P.y) * (x[1] - P.y) > 1e-12 * Th[k].area) {
        std::ostringstream text;
        text << "node " << nodes[a] << " is at (" << x[0] << ", " << x[1] << ") and at (" << P.x << ", "
             << P.y << "), expected one place: periodic spaces are not supported";
        fail(where, text.str());
      }
      placed[nodes[a]] = 1;
      x[0] = P.x;
      x[1] = P.y;
    }
  }
  mesh.facets = edges_of(V, where);
  return mesh;
}

std::shared_ptr<const ::Mesh> shared_mesh(pfes* const& space, const char* where) {
  const ::Mesh* mesh = &space_of(space, where).Th;
  mesh->increment();
  return {mesh, [](const ::Mesh* shared) { shared->destroy(); }};
}

} // namespace burnish

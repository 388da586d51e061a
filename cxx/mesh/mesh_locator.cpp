#include "mesh/mesh_locator.hpp"
#include <algorithm>
#include <array>
#include <map>

namespace burnish {
namespace {

/// An element contains a point outside by this in barycentric coordinates: rounding.
constexpr double INSIDE = 1e-10;

} // namespace

template <int Dim> MeshLocator<Dim>::MeshLocator(const Mesh<Dim>& d) : m_mesh(&d) {
  m_neighbor.assign(static_cast<std::size_t>(d.num_elements) * (Dim + 1), -1);
  m_any_element.assign(d.num_nodes, -1);
  std::map<std::array<int, Dim>, int> open; // face vertices, sorted -> element * (Dim+1) + opposite vertex
  for (int e = 0; e < d.num_elements; ++e) {
    const int* nodes = d.element(e);
    for (int a = 0; a < d.nodes_per_element; ++a) m_any_element[nodes[a]] = e;
    for (int v = 0; v <= Dim; ++v) {
      std::array<int, Dim> face;
      for (int a = 0, k = 0; a <= Dim; ++a)
        if (a != v) face[k++] = nodes[a];
      std::sort(face.begin(), face.end());
      const int here = e * (Dim + 1) + v;
      const auto [it, fresh] = open.emplace(face, here);
      if (fresh) continue;
      m_neighbor[here] = it->second / (Dim + 1);
      m_neighbor[it->second] = e;
      open.erase(it);
    }
  }
}

template <int Dim> Barycentric<Dim> MeshLocator<Dim>::barycentric(int element, const Vector<Dim>& P) const {
  const int* nodes = m_mesh->element(element);
  Tensor<Dim> edges;
  for (int c = 0; c < Dim; ++c) edges.col(c) = m_mesh->node(nodes[c + 1]) - m_mesh->node(nodes[0]);
  const Vector<Dim> l = edges.inverse() * (P - m_mesh->node(nodes[0]));
  Barycentric<Dim> result;
  result[0] = 1 - l.sum();
  result.template tail<Dim>() = l;
  return result;
}

template <int Dim> int MeshLocator<Dim>::find(const Vector<Dim>& P, int near, double slack) const {
  int element = m_any_element[near];
  for (int walk = 0; element >= 0 && walk < m_mesh->num_elements; ++walk) {
    Barycentric<Dim> l = barycentric(element, P);
    int next = -1;
    for (int tried = 0; tried <= Dim && next < 0;
         ++tried) { // leave through the most negative face that has a neighbor
      Eigen::Index v;
      if (l.minCoeff(&v) >= -INSIDE) break;
      next = m_neighbor[element * (Dim + 1) + static_cast<int>(v)];
      if (next < 0) {
        if (l[v] < -slack) return -1;
        l[v] = 0;
      }
    }
    if (next < 0) return element;
    element = next;
  }
  return -1;
}

template <int Dim> void MeshLocator<Dim>::shape(int element, const Vector<Dim>& P, double* N) const {
  shape_functions<Dim>(m_mesh->nodes_per_element, barycentric(element, P), N);
}

template class MeshLocator<2>;
template class MeshLocator<3>;

} // namespace burnish

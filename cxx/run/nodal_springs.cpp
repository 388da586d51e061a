#include "run/nodal_springs.hpp"
#include <cmath>

namespace burnish {
namespace {

// Volume of an element with straight edges: per unit of thickness in the plane, of the whole ring if axisymmetric.
template <int Dim> double volume_of(const Mesh<Dim>& mesh, int element) {
  constexpr double factorial = Dim == 2 ? 2 : 6, pi = 3.14159265358979323846;
  const int* nodes = mesh.element(element);
  Tensor<Dim> edges;
  double radius = 0;
  for (int c = 0; c < Dim; ++c) edges.col(c) = mesh.node(nodes[c + 1]) - mesh.node(nodes[0]);
  for (int c = 0; c <= Dim; ++c) radius += mesh.node(nodes[c])[0] / (Dim + 1);
  return std::abs(edges.determinant()) / factorial * (mesh.axisymmetric ? 2 * pi * radius : 1);
}

} // namespace

// Every node of an element has the same part of its volume.
template <int Dim>
NodalSprings<Dim>::NodalSprings(const Mesh<Dim>& mesh, const BodyView<Dim>& body) : m_body(body) {
  m_volume = Eigen::VectorXd::Zero(mesh.num_nodes);
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int a = 0; a < mesh.nodes_per_element; ++a)
      m_volume[mesh.element(e)[a]] += volume_of(mesh, e) / mesh.nodes_per_element;
}

template <int Dim>
Eigen::VectorXd NodalSprings<Dim>::force(double stiffness, const Eigen::VectorXd& u,
                                         const Eigen::VectorXd& origin) const {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(u.size());
  for (Eigen::Index d = 0; d < u.size(); ++d)
    if (!m_body.fixed[d]) f[d] = -stiffness * m_volume[d / Dim] * (u[d] - origin[d]);
  return f;
}

template <int Dim> void NodalSprings<Dim>::add_stiffness(double stiffness, NodeBlockMatrix<Dim>& K) const {
  for (int node = 0; node < K.num_nodes; ++node) {
    double* block = K.block(K.find(node, node));
    for (int c = 0; c < Dim; ++c)
      if (!m_body.fixed[Dim * node + c]) block[c * Dim + c] += stiffness * m_volume[node];
  }
}

template <int Dim> double NodalSprings<Dim>::stiffness_of(const NodeBlockMatrix<Dim>& K) const {
  double diagonal = 0;
  for (int node = 0; node < K.num_nodes; ++node) {
    const double* block = K.block(K.find(node, node));
    for (int c = 0; c < Dim; ++c) diagonal += block[c * Dim + c] / Dim;
  }
  return diagonal / m_volume.sum();
}

template class NodalSprings<2>;
template class NodalSprings<3>;

} // namespace burnish

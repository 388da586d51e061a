#include "remesh/deformed_mesh.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

// Edges from vertex 0 of the equilateral simplex, as columns.
Tensor<2> equilateral(const Vector<2>&) {
  Tensor<2> edges;
  edges << 1, 0.5, 0, std::sqrt(3.) / 2;
  return edges;
}
Tensor<3> equilateral(const Vector<3>&) {
  Tensor<3> edges;
  edges << 1, 0.5, 0.5, 0, std::sqrt(3.) / 2, std::sqrt(3.) / 6, 0, 0, std::sqrt(2. / 3);
  return edges;
}

template <int Dim> Tensor<Dim> edges_of(const Mesh<Dim>& mesh, int element) {
  const int* node = mesh.element(element);
  Tensor<Dim> edges;
  for (int c = 0; c < Dim; ++c) edges.col(c) = mesh.node(node[c + 1]) - mesh.node(node[0]);
  return edges;
}
template <int Dim> double shape_of(const Tensor<Dim>& edges) {
  const Tensor<Dim> J = edges * equilateral(Vector<Dim>()).inverse();
  return Dim * std::pow(std::max(J.determinant(), 0.), 2. / Dim) / J.squaredNorm();
}

} // namespace

template <int Dim> Discretization<Dim> deformed(Discretization<Dim> mesh, const Eigen::VectorXd& u) {
  require(u.size() == mesh.num_dofs(), "deformed", "size of u", u.size(), "num_dofs");
  for (Eigen::Index d = 0; d < u.size(); ++d) mesh.X[static_cast<std::size_t>(d)] += u[d];
  for (int p = 0; p < mesh.num_points(); ++p) {
    Eigen::Map<Vector<Dim>> x(&mesh.point[static_cast<std::size_t>(Dim) * p]);
    x.setZero();
    for (int a = 0; a < mesh.nodes_per_element; ++a)
      x += mesh.shapes(p)[a] * mesh.node(mesh.element(p / mesh.points_per_element)[a]);
  }
  return mesh;
}

template <int Dim> double deformed_volume(const Workpiece<Dim>& body) {
  double sum = 0;
  for (int p = 0; p < body.discretization().num_points(); ++p)
    sum += body.discretization().weight[p] * determinant(Gradient<Dim>(point_state(body.state_old(), p).F));
  return sum;
}

template <int Dim> double least_shape(const Workpiece<Dim>& body) {
  const Discretization<Dim>& mesh = body.discretization();
  double least = 1;
  for (int p = 0; p < mesh.num_points(); ++p) {
    const Gradient<Dim> F = point_state(body.state_old(), p).F;
    least = std::min(least, shape_of<Dim>(mesh_part<Dim>(F) * edges_of(mesh, p / mesh.points_per_element)));
  }
  return least;
}

template <int Dim> double reference_shape(const Discretization<Dim>& mesh) {
  double least = 1;
  for (int e = 0; e < mesh.num_elements; ++e) least = std::min(least, shape_of<Dim>(edges_of(mesh, e)));
  return least;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template Discretization<Dim> deformed<Dim>(Discretization<Dim>, const Eigen::VectorXd&);                   \
  template double deformed_volume<Dim>(const Workpiece<Dim>&);                                               \
  template double least_shape<Dim>(const Workpiece<Dim>&);                                                   \
  template double reference_shape<Dim>(const Discretization<Dim>&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish

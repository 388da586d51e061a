#include "workpiece/point_place.hpp"

namespace burnish {

template <int Dim>
Vector<Dim> point_place(const Discretization<Dim>& mesh, int point, const WorkpieceState<Dim>& state) {
  const std::size_t p = point;
  const Vector<Dim> X = Eigen::Map<const Vector<Dim>>(mesh.point.data() + Dim * p);
  const int* element = mesh.element(point / mesh.points_per_element);
  int nearest = element[0];
  for (int a = 1; a < mesh.nodes_per_element; ++a)
    if ((mesh.node(element[a]) - X).squaredNorm() < (mesh.node(nearest) - X).squaredNorm())
      nearest = element[a];
  const Eigen::Map<const Tensor<Dim>> F_transposed(state.F.data() + Dim * Dim * p); // row-major there
  return mesh.node(nearest) + state.displacement.template segment<Dim>(Dim * nearest) +
         F_transposed.transpose() * (X - mesh.node(nearest));
}

template Vector<2> point_place<2>(const Discretization<2>&, int, const WorkpieceState<2>&);

} // namespace burnish

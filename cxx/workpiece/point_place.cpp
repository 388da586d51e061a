#include "workpiece/point_place.hpp"

namespace burnish {

template <int Dim>
Vector<Dim> point_place(const Discretization<Dim>& mesh, int point, const WorkpieceState<Dim>& state) {
  Vector<Dim> x = Eigen::Map<const Vector<Dim>>(mesh.point.data() + static_cast<std::size_t>(Dim) * point);
  const int* node = mesh.element(point / mesh.points_per_element);
  for (int a = 0; a < mesh.nodes_per_element; ++a)
    x += mesh.shapes(point)[a] * state.displacement.template segment<Dim>(Dim * node[a]);
  return x;
}

template Vector<2> point_place<2>(const Discretization<2>&, int, const WorkpieceState<2>&);
template Vector<3> point_place<3>(const Discretization<3>&, int, const WorkpieceState<3>&);

} // namespace burnish

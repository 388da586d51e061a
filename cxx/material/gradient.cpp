#include "material/gradient.hpp"
#include <Eigen/LU>

namespace burnish {

double determinant(const Gradient<3>& F) { return mesh_part<3>(F).determinant(); }

Gradient<3> inverse(const Gradient<3>& F) {
  Gradient<3> result;
  mesh_part<3>(result) = mesh_part<3>(F).inverse();
  return result;
}

Gradient<3> product(const Gradient<3>& a, const Gradient<3>& b) {
  Gradient<3> result;
  mesh_part<3>(result).noalias() = mesh_part<3>(a) * mesh_part<3>(b);
  return result;
}

} // namespace burnish

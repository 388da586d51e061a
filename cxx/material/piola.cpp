#include "material/piola.hpp"

namespace burnish {

Gradient<3> first_piola(const Stress<3>& stress, const Gradient<3>& F_inverse) {
  Gradient<3> P;
  mesh_part<3>(P).noalias() = matrix_of<3>(stress) * mesh_part<3>(F_inverse).transpose();
  return P;
}

} // namespace burnish

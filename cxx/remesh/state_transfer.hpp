#pragma once
// The state of a workpiece on a new mesh of it (METHOD.md 1.17).
#include "remesh/deformed_mesh.hpp"

namespace burnish {

template <int Dim> struct TransferredState {
  WorkpieceState<Dim> workpiece;
  std::vector<int> origin; ///< per point of the new mesh: the nearest one of the old mesh
  Eigen::VectorXd
      du; ///< displacement increment of the last step at the new nodes; empty where none is given [length]
};

/// Accepted state of a workpiece on a mesh of its deformed body. Cauchy stress and internal variables are fitted, METHOD.md
/// (1.42), and brought back to the yield surface, METHOD.md (1.43); whether a point flows is that of the nearest one.
/// @param fresh  workpiece on the new mesh, of the same law, undeformed
/// @param start  displacement of the new mesh, see boundary_displacement; num_dofs of it [length]
/// @param du     of the last step on the old mesh [length]; empty: none
/// @throws std::invalid_argument for a law of small strains, whose body has no deformed place; for a mesh that is not one of
///         the deformed body
template <int Dim>
TransferredState<Dim> transferred(const Workpiece<Dim>& old, Workpiece<Dim>& fresh,
                                  const Eigen::VectorXd& start, const Eigen::VectorXd& du);

} // namespace burnish

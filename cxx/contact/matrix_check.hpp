#pragma once
// Whether a matrix that a script hands to a contact can be one of its mesh.
#include "mesh/mesh.hpp"
#include "solver/node_block_matrix.hpp"
#include <cstdint>

namespace burnish {

/// Notes that this matrix is the tangent of a material on a mesh; the last 16 are remembered, by their values.
/// @param fingerprint mesh_fingerprint of the mesh
template <int Dim>
void note_tangent(const NodeBlockMatrix<Dim>& K, std::uint64_t fingerprint, bool axisymmetric);

class MatrixCheck {
public:
  /// @throws std::invalid_argument "where: ..." if most of its entries join nodes that no element joins, or if it is the
  ///         tangent of a material on another mesh, or an axisymmetric one of a plane mesh
  template <int Dim> void require_of(const Mesh<Dim>& mesh, const NodeBlockMatrix<Dim>& K, const char* where);

private:
  std::uint64_t m_fingerprint = 0;     // of the mesh; 0: not known yet
  std::vector<int> m_row_start, m_col; // of the last pattern that was right
};

} // namespace burnish

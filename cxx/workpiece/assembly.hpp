#pragma once
// From stresses and moduli at quadrature points to nodal forces and their tangent. Knows no law.
#include "material/piola.hpp"
#include "mesh/discretization.hpp"
#include "solver/node_block_matrix.hpp"
#include <cstdint>

namespace burnish {

/// force += the contribution of a point: V0 P grad_X N, and where axisymmetric V0 P_zz N/R on the radial dof [force].
/// @param P first Piola stress there [stress]; @param force num_dofs
template <int Dim>
void add_force(const Discretization<Dim>& mesh, int point, const Gradient<Dim>& P, Eigen::VectorXd& force);

/// The pattern of the tangent and the places of every element's blocks in it.
template <int Dim> class TangentAssembly {
public:
  TangentAssembly() = default;
  /// @throws std::invalid_argument for a node with more neighbors than m_slot can count (names it)
  explicit TangentAssembly(const Discretization<Dim>& mesh);
  /// Without values.
  const NodeBlockMatrix<Dim>& pattern() const { return m_pattern; }
  /// Whether the matrix has this pattern, with or without values.
  bool fits(const NodeBlockMatrix<Dim>& matrix) const;
  /// matrix += the contribution of a point with the moduli A = dP/dF, of which the blocks on and above the diagonal of the
  /// element count; the others are their transposes. @param mesh that of the constructor; @param matrix fits, with values
  void add(const Discretization<Dim>& mesh, int point, const PiolaTangent<Dim>& A,
           NodeBlockMatrix<Dim>& matrix) const;
  /// The same for antisymmetric moduli: the other blocks are the negative transposes.
  void add_antisymmetric(const Discretization<Dim>& mesh, int point, const PiolaTangent<Dim>& A,
                         NodeBlockMatrix<Dim>& matrix) const;

private:
  template <int Mirror>
  void add_mirrored(const Discretization<Dim>& mesh, int point, const PiolaTangent<Dim>& A,
                    NodeBlockMatrix<Dim>& matrix) const;

  NodeBlockMatrix<Dim> m_pattern;
  std::vector<std::uint16_t> m_slot; // element x node x node: block in the first node's row of the pattern
};

} // namespace burnish

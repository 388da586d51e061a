#pragma once
// Springs from the nodes of a body, each with its part of the volume: of a soft hold, of the viscosity of a march.
#include "contact/body_view.hpp"
#include "mesh/mesh.hpp"
#include "solver/node_block_matrix.hpp"

namespace burnish {

template <int Dim> class NodalSprings {
public:
  /// @param mesh, body must outlive it
  NodalSprings(const Mesh<Dim>& mesh, const BodyView<Dim>& body);
  /// Force on the nodes at u, num_dofs, 0 at given components [force].
  /// @param stiffness per reference volume [stress/length^2]; @param origin displacement that the springs pull to [length]
  Eigen::VectorXd force(double stiffness, const Eigen::VectorXd& u, const Eigen::VectorXd& origin) const;
  /// Adds their stiffness to a tangent.
  void add_stiffness(double stiffness, NodeBlockMatrix<Dim>& K) const;
  /// The stiffness per volume of springs that are as stiff as the diagonal of K in the mean [stress/length^2].
  double stiffness_of(const NodeBlockMatrix<Dim>& K) const;

private:
  const BodyView<Dim>& m_body;
  Eigen::VectorXd m_volume; // per node, reference
};

/// Sum of the norms of nodal forces [force].
template <int Dim> double sum_of_norms(const Eigen::VectorXd& f) {
  double sum = 0;
  for (Eigen::Index d = 0; d < f.size(); d += Dim) sum += f.template segment<Dim>(d).norm();
  return sum;
}

} // namespace burnish

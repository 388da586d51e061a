#pragma once
// What the contact code knows of the workpiece: where its nodes are and which are held.
#include "base/types.hpp"
#include <vector>

namespace burnish {

/// What both integrators know of the workpiece: nodes, fixed dofs, spacing of the candidates.
template <int Dim> struct BodyView {
  Eigen::VectorXd X;         ///< reference coordinates, num_dofs [length]
  std::vector<char> fixed;   ///< per dof: displacement given (zero increment)
  double spacing = 0;        ///< typical distance of neighboring candidates [length]
  bool axisymmetric = false; ///< x is the radius, forces are those of whole rings
  Vector<Dim> position(const Eigen::VectorXd& u, int node) const {
    return X.segment<Dim>(Dim * node) + u.segment<Dim>(Dim * node);
  }
};

/// Whether the fixed dofs rule out every rigid motion of the body (in the plane: two translations and the
/// rotation, small motions).
template <int Dim> bool holds_rigid_motions(const BodyView<Dim>& body);

/// Typical distance of neighboring candidates: median of the distances to the nearest other candidate.
double candidate_spacing(const Eigen::VectorXd& X, int dim, const std::vector<int>& candidates);

} // namespace burnish

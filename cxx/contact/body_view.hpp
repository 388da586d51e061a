#pragma once
// What the contact code knows of the workpiece: where its nodes are, which are fixed, how its surface is measured.
#include "mesh/facet_measure.hpp"
#include <memory>

namespace burnish {

template <int Dim> struct BodyView {
  Eigen::VectorXd X;       ///< reference places of the nodes, those of the surface on its curve [length]
  std::vector<char> fixed; ///< per dof: displacement given (zero increment)
  double spacing = 0;      ///< typical distance of neighboring candidates [length]
  std::shared_ptr<const FacetMeasure<Dim>> measure; ///< for tributary areas and reports
  Vector<Dim> position(const Eigen::VectorXd& u, int node) const {
    return X.segment<Dim>(Dim * node) + u.segment<Dim>(Dim * node);
  }
};

/// Whether the fixed dofs rule out every rigid motion of the body: translations and small rotations.
template <int Dim> bool constrains_rigid_motions(const BodyView<Dim>& body);

/// Typical distance of neighboring candidates: median of the distances to the nearest other candidate; 0 if there is
/// none [length].
template <int Dim> double candidate_spacing(const Eigen::VectorXd& X, const std::vector<int>& candidates);

} // namespace burnish

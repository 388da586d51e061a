#pragma once
// Where the mid nodes of a quadratic contact surface lie: on the curve that its vertices were taken from, not on the chords
// between them (METHOD.md 3.18).
#include "mesh/mesh.hpp"
#include <Eigen/Core>

namespace burnish {

/// Reference places of all nodes in contact problems: those of the mesh, with the mid nodes of the surface's edges on the
/// curve through their vertices. Of an edge of length h between vertices with the curvatures k it bulges by k h^2/8; k at a
/// vertex is that of the circle through it and its neighbors along the surface. Where the surface turns by more than
/// `corner` there is a corner: nothing is fitted across it. Where k changes by more than a factor of two along an edge the
/// smaller one counts, none where its sign changes: the joint of a line and an arc. In space the places are those of the
/// mesh.
/// @param corner least angle of a corner [rad]
/// @returns num_dofs [length]
template <int Dim>
Eigen::VectorXd places_on_curve(const Mesh<Dim>& mesh, const std::vector<Facet<Dim>>& surface,
                                double corner = 0.6);
// (specialized for each dimension: told before any use)
template <> Eigen::VectorXd places_on_curve<2>(const Mesh<2>&, const std::vector<Facet<2>>&, double);
template <> Eigen::VectorXd places_on_curve<3>(const Mesh<3>&, const std::vector<Facet<3>>&, double);

/// The same with the mid nodes where the script says.
/// @param places num_dofs; only those of the mid nodes of the surface count [length]
/// @throws std::invalid_argument for a wrong size, a place that is not finite, or farther from the middle of its edge than
/// a quarter of its length
template <int Dim>
Eigen::VectorXd places_given(const Mesh<Dim>& mesh, const std::vector<Facet<Dim>>& surface,
                             const Eigen::VectorXd& places);

} // namespace burnish

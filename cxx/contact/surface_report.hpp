#pragma once
// What acts on the contact surface, node by node.
#include "contact/tributary_area.hpp"

namespace burnish {

/// Part of the largest friction from which a corner counts as one that slides in SurfaceReport::stick_share.
inline constexpr double NEAR_LIMIT = 0.97;

/// State of the candidates, one entry each. Pressure and traction are nodal forces over the node's tributary area in the
/// present configuration. A vertex of quadratic elements without an area of its own (OWN_AREA: on the axis, or next
/// to it) takes the values by shares.
template <int Dim> struct SurfaceReport {
  Eigen::VectorXd gap;          ///< positive = open, zero in contact [length]
  Eigen::VectorXd normal_force; ///< N >= 0 [force]
  Eigen::MatrixXd
      tangential_force;     ///< of the tool on the body, Dim-1 x candidates, in the tangents E [force]
  Eigen::VectorXd area;     ///< tributary area [length, in space and axisymmetric: area]
  Eigen::VectorXd pressure; ///< [stress]
  Eigen::MatrixXd traction_tangential; ///< on the body, Dim-1 x candidates [stress]
  /// Pressure and traction that are linear on every facet, of forces shared to the corners (CornerShares): without the
  /// alternation of quadratic elements, within the cone at every corner, and with the sum of the nodal forces. Linear
  /// facets: as above.
  Eigen::VectorXd pressure_fit; ///< [stress]
  Eigen::MatrixXd traction_fit; ///< [stress]
  /// Share of the area in contact that sticks, 0 without contact: of quadratic facets the corners whose shared friction is
  /// below NEAR_LIMIT of its limit, of linear ones the nodes that stick.
  double stick_share = 0;
};

/// @param R internal minus external nodal force [force]; @param u displacement
template <int Dim>
SurfaceReport<Dim> surface_report(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                  const ContactState<Dim>& state, const std::vector<Facet<Dim>>& facets,
                                  const Eigen::VectorXd& u, const Eigen::VectorXd& R);

} // namespace burnish

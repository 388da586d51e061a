#pragma once
// What acts on the contact surface, node by node.
#include "contact/tributary_area.hpp"

namespace burnish {

/// Part of the largest friction from which a corner counts as one that slides in SurfaceReport::stick_share.
inline constexpr double NEAR_LIMIT = 0.97;

/// State of the candidates, one entry each, in the present configuration.
template <int Dim> struct SurfaceReport {
  Eigen::VectorXd gap;          ///< positive = open, zero in contact [length]
  Eigen::VectorXd normal_force; ///< N >= 0 [force]
  Eigen::MatrixXd
      tangential_force; ///< of the tool on the body, Dim-1 x candidates, in the tangents E [force]
  Eigen::VectorXd area; ///< tributary area [length, in space and axisymmetric: area]
  /// Pressure and traction on the body, linear on every facet, of forces shared to the corners (CornerShares): without the
  /// alternation of quadratic elements, nowhere negative where no nodal force is, within the cone at every corner, and with
  /// the sum of the nodal forces. A free node next to a corner has a part of its value. Linear facets: the nodal ones.
  Eigen::VectorXd pressure;            ///< [stress]
  Eigen::MatrixXd traction_tangential; ///< Dim-1 x candidates [stress]
  /// Nodal forces over tributary areas, 0 where there is none (NO_AREA).
  Eigen::VectorXd nodal_pressure; ///< [stress]
  Eigen::MatrixXd nodal_traction; ///< Dim-1 x candidates [stress]
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

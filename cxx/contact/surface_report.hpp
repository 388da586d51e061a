#pragma once
// What acts on the contact surface, node by node.
#include "contact/tributary_area.hpp"

namespace burnish {

/// Part of the largest friction from which a corner counts as one that slides in SurfaceReport::stick_share.
inline constexpr double NEAR_LIMIT = 0.97;

/// Components of a tangential force or traction in a report: in the plane one, along the tangent E of the tool; in space x, y, z, since
/// tangents of neighboring nodes need not agree.
template <int Dim> inline constexpr int SHEAR_COMPONENTS = Dim == 2 ? 1 : 3;

/// State of the candidates, one entry each, in the present configuration.
template <int Dim> struct SurfaceReport {
  Eigen::VectorXd gap;              ///< positive = open, zero in contact [length]
  Eigen::VectorXd normal_force;     ///< N >= 0 [force]
  Eigen::MatrixXd tangential_force; ///< of the tool on the body, SHEAR_COMPONENTS x candidates [force]
  Eigen::VectorXd area;             ///< tributary area [length, in space and axisymmetric: area]
  /// Pressure and traction on the body, linear on every facet, of forces shared to the corners (CornerShares): without the
  /// alternation of quadratic elements, nowhere negative where no nodal force is, within the cone at every corner, and with
  /// the sum of the nodal forces. A free node next to a corner has a part of its value. Linear facets: the nodal ones.
  Eigen::VectorXd pressure;            ///< [stress]
  Eigen::MatrixXd traction_tangential; ///< SHEAR_COMPONENTS x candidates [stress]
  /// Nodal forces over tributary areas, 0 where there is none (NO_AREA).
  Eigen::VectorXd nodal_pressure; ///< [stress]
  Eigen::MatrixXd nodal_traction; ///< SHEAR_COMPONENTS x candidates [stress]
  /// Share of the area in contact that sticks, 0 without contact: of quadratic facets the corners whose shared friction is
  /// below NEAR_LIMIT of its limit, of linear ones the nodes that stick.
  double stick_share = 0;
};

/// Tangential force or traction of a report as a vector. @param E the tool's tangents; in space not used
template <int Dim>
Vector<Dim> shear_vector(const Tangents<Dim>& E,
                         const Eigen::Matrix<double, SHEAR_COMPONENTS<Dim>, 1>& shear) {
  if constexpr (Dim == 2)
    return E * shear;
  else
    return shear;
}

/// @param R internal minus external nodal force [force]; @param u displacement
template <int Dim>
SurfaceReport<Dim> surface_report(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                  const ContactState<Dim>& state, const std::vector<Facet<Dim>>& facets,
                                  const Eigen::VectorXd& u, const Eigen::VectorXd& R);

} // namespace burnish

#pragma once
// The contact surface: its edges, its nodes in order, and what acts on them.
#include "contact/surface_share.hpp"

namespace burnish {

/// State of the candidates, one entry each. Pressure and traction are nodal forces over the node's share of
/// the surface in the present configuration (surface_share.hpp).
template <int Dim> struct SurfaceReport {
  Eigen::VectorXd gap;                 ///< positive = open, zero in contact [length]
  Eigen::VectorXd normal_force;        ///< N >= 0 [force]
  Eigen::VectorXd tangential_force;    ///< of the tool on the body, along the tool's tangent X_s [force]
  Eigen::VectorXd area;                ///< share of the surface [length, axisymmetric: area]
  Eigen::VectorXd pressure;            ///< [stress]
  Eigen::VectorXd traction_tangential; ///< on the body [stress]
  /// The pressure and traction that are linear on every edge and whose consistent nodal forces fit the nodal
  /// forces in least squares (zero at free ends; middle nodes: mean of the ends): without the alternation of
  /// quadratic elements. Linear edges: as above.
  Eigen::VectorXd pressure_fit, traction_fit; ///< [stress]
};

/// @param R internal minus external nodal force [force]; @param u displacement
template <int Dim>
SurfaceReport<Dim> surface_report(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                  const ContactState<Dim>& state, const std::vector<Facet<2>>& edges,
                                  const Eigen::VectorXd& u, const Eigen::VectorXd& R);

} // namespace burnish

#pragma once
// Residual and linearization of one contact node: the rows W, the columns A and the geometric terms of
// method.md 3.
#include "contact/contact_model.hpp"

namespace burnish {

/// Which second-derivative terms enter K^ (article eq. 1.20, 1.21; method.md section 3).
enum class GeometricTerms {
  COMPLETE, ///< all four parts: symmetric without friction, quadratic convergence
  ARTICLE,  ///< only the (s,s) and (s,q) parts of the article
  NONE,
};

/// One contact node in the plane or in space. F is the internal nodal force = force of the tool on the node.
template <int Dim> struct NodeLinearization {
  int candidate = -1, tool = -1;
  bool sliding = false;
  /// Not in contact: its displacement is unknown and no force acts on it (see ContactBlockInput::shift).
  bool loose = false;
  SurfacePoint<Dim> point;
  PerCoordinate<Dim> x_q; ///< displacement per coordinate: X_,k, or along the lift of a held node
  // sliding rows (article 1.13): tau . F + constant = 0
  Vector<Dim> tau = Vector<Dim>::Zero(); ///< row: X_s + sgn |X_s| g'(N) n
  double constant = 0;                   ///< sgn |X_s| (g - g' N); zero for Coulomb
  // geometric terms
  double geo_ss = 0;
  Eigen::VectorXd geo_sq, geo_qs; ///< coordinates of this tool
  Eigen::MatrixXd geo_qq;
};

/// @param R internal minus external nodal force at the linearization point, Dim [force]
/// Plane only for sliding nodes (one tangent); sticking nodes in any dimension.
template <int Dim>
NodeLinearization<Dim> linearize_node(const ContactModel<Dim>& model, const ContactNode<Dim>& node,
                                      int candidate, const std::vector<Pose<Dim>>& poses,
                                      const Vector<Dim>& R, GeometricTerms terms);

/// Residual of a sliding node, X_s . F + sgn |X_s| g(F . n)  [force x length / parameter].
template <int Dim> double sliding_residual(const NodeLinearization<Dim>& node, const Vector<Dim>& F);

} // namespace burnish

#pragma once
// Residual and linearization of one contact node: the rows W, the columns A and the geometric terms of METHOD.md 3.2.
#include "contact/tied_motion.hpp"

namespace burnish {

/// Which second-derivative terms enter K^ (METHOD.md 3.6, article (1.20), (1.21)).
enum class GeometricTerms {
  COMPLETE, ///< all four parts: symmetric without friction, quadratic convergence
  ARTICLE,  ///< only the (s,s) and (s,q) parts of the article
  NONE,
};

/// What a tied mid node moves by, and adds to the row of, the slip of a sliding end of its edge (METHOD.md 3.19).
template <int Dim> struct TiedRow {
  int end = -1;                       ///< candidate
  Tangents<Dim> A;                    ///< its columns
  Tangents<Dim> W;                    ///< part of the end's rows
  std::vector<Curvature<Dim>> geo_ss; ///< in these rows, with the slip of each of the node's ties
  Eigen::MatrixXd geo_sq, geo_qs;     ///< as those of a sliding node
};

/// One contact node. F is the internal nodal force = force of the tool on the node. Columns A: E for its slip, x_q for
/// the coordinates of its tool; rows: W'F + constant = 0, and x_q'F for the coordinates.
template <int Dim> struct NodeLinearization {
  int candidate = -1, tool = -1;
  bool in_contact = true; ///< false: its displacement is unknown, no force acts on it (ContactBlockInput)
  bool sliding = false;   ///< has unknown slips, Dim-1 of them
  SurfacePoint<Dim> point;
  Tangents<Dim> E = Tangents<Dim>::Zero(); ///< columns of its slip: point.E, less what the supports hold
  Vector<Dim> F = Vector<Dim>::Zero();     ///< force of the tool on it at the linearization point [force]
  std::vector<int> at; ///< coordinates that the columns of x_q and the geometric terms belong to: places in q
  PerCoordinate<Dim>
      x_q; ///< displacement per coordinate: X_,k, or along the admissible normal of a constrained node
  Tangents<Dim> W = Tangents<Dim>::Zero();
  Param<Dim> constant = Param<Dim>::Zero();
  // geometric terms
  Curvature<Dim> geo_ss = Curvature<Dim>::Zero();
  Eigen::MatrixXd geo_sq, geo_qs; ///< Dim-1 x coordinates of this tool; and its counterpart, transposed
  Eigen::MatrixXd geo_qq;
  std::vector<TiedRow<Dim>> ties; ///< of a tied mid node, which has no slip of its own
};

/// The cone that counts for a sliding node, and for a tied one those of the ends of its edge; see cones_of.
template <int Dim> struct NodeCones {
  bool tied = false;
  ConeTangent own;
  SlipTurn<Dim> turn; ///< of its own slip
  struct End {
    int candidate;
    Param<Dim> m; ///< direction of its slip
    ConeTangent cone;
    SlipTurn<Dim> turn;
    TiedEnd<Dim> motion;
  };
  Curvature<Dim> foot_slope = Curvature<Dim>::Identity(); ///< of a tied node
  std::vector<End> ends;                                  ///< of a tied node: those that slide
};

/// @param R internal minus external nodal force at the linearization point, Dim [force]
/// @param cones null: the node's own
template <int Dim>
NodeLinearization<Dim> linearize_node(const ContactModel<Dim>& model, const ContactNode<Dim>& node,
                                      int candidate, const std::vector<Pose<Dim>>& poses,
                                      const Vector<Dim>& R, GeometricTerms terms,
                                      const NodeCones<Dim>* cones = nullptr);

} // namespace burnish

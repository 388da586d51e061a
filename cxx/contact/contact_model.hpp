#pragma once
// What may touch what: candidate nodes, tools, laws along the surface.
#include "contact/tangential_law.hpp"

namespace burnish {

/// Components of the displacement of a candidate that are given (a node on a symmetry line or plane). Contact acts along
/// the free ones only (the support takes what is across them). One free component: the node slides as it must, without
/// friction. Two, in space: it sticks and slips along their plane, with friction (METHOD.md 3.7).
template <int Dim> using ConstrainedComponents = std::array<bool, Dim>;

/// A coordinate that follows others: q_dependent = formula(q), METHOD.md 2.6.
struct Coupling {
  int dependent = -1;                               ///< its place in q
  std::shared_ptr<const CoordinateFormula> formula; ///< values: q, all coordinates of the contact
};

template <int Dim> struct ContactModel {
  std::vector<int> candidates; ///< mesh nodes that may touch a tool
  std::vector<std::shared_ptr<const Tool<Dim>>> tools;
  std::vector<TangentialLaw<Dim>> laws; ///< one per tool
  std::vector<int> first;               ///< first coordinate of each tool in q; last entry: total
  std::vector<ConstrainedComponents<Dim>> constrained; ///< per candidate; empty: none is
  std::vector<std::vector<char>> reach; ///< per tool and candidate: may touch; empty: every candidate

  /// Per candidate: the ends of the edge that it is the mid node of, or -1; empty: linear facets.
  std::vector<std::array<int, 2>> edge_ends;
  /// Per candidate: vertex of quadratic triangles, whose shape function has no area. It has no friction unless it bears, has
  /// ties (ContactNode) or its law always sticks, and is released by shared forces (METHOD.md 3.19). Empty: none is.
  std::vector<char> weightless;

  std::vector<std::vector<int>>
      neighbors;                   ///< per candidate: those next to it along the surface; empty: nobody asks
  std::vector<Coupling> couplings; ///< relations between coordinates; what follows is followed by nothing

  /// The relation that coordinate k follows, null if it is independent.
  const Coupling* coupling_of(int k) const;
  /// Coordinates that follow k.
  std::vector<int> followers(int k) const;
  /// Whether the candidate is the mid node of an edge both ends of which are candidates.
  bool is_middle(int candidate) const { return !edge_ends.empty() && edge_ends[candidate][0] >= 0; }
  int tool_of(int k) const; ///< tool that entry k of q belongs to
  bool is_constrained(int candidate) const;
  bool is_weightless(int candidate) const { return !weightless.empty() && weightless[candidate]; }
  /// Whether its supports leave it a direction along the tool.
  bool can_slip(int candidate) const;
  bool may_touch(int candidate, int tool) const;
  /// Law between a candidate that touches and a tool: without friction where it cannot slip, and of weightless ones that may slide.
  const TangentialLaw<Dim>& law(int candidate, int tool) const;
  /// The same of its present state.
  const TangentialLaw<Dim>& law(int candidate, const ContactNode<Dim>& node) const;
  int num_coordinates() const { return first.empty() ? 0 : first.back(); }
  Eigen::VectorXd tool_q(const Eigen::VectorXd& q, int tool) const {
    return q.segment(first[tool], first[tool + 1] - first[tool]);
  }
  /// "coordinate "x" of tool "roller"" for entry k of q, for messages.
  std::string coordinate(int k) const;
  std::vector<Pose<Dim>> poses(const Eigen::VectorXd& q) const;
  bool symmetric() const; ///< true if no tool has friction
};

/// Place among the candidates of every mesh node, -1 for the others.
std::vector<int> candidate_of_node(const std::vector<int>& candidates, int num_nodes);

/// Nearest tool of a point and the closest point on it; tool -1 and an infinite gap if there is none.
template <int Dim> struct NearestTool {
  int tool = -1;
  SurfaceFoot<Dim> foot;
};
/// @param near      its tool and place start the search
/// @param candidate asks only tools that it may touch; -1: all tools
template <int Dim>
NearestTool<Dim> nearest_tool(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses,
                              const Vector<Dim>& x, const ContactNode<Dim>& near, int candidate);

/// A node in contact where its tool is: surface point, and direction of its slip in the tangents E there (unit, or zero
/// without friction or slip).
template <int Dim> struct ContactPoint {
  SurfacePoint<Dim> surface;
  Param<Dim> m;
};
template <int Dim>
ContactPoint<Dim> contact_point(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses,
                                const ContactNode<Dim>& node);
/// A direction in the tangents of a surface point as one of the tool's frame, for ContactNode::slip_direction.
template <int Dim>
Vector<Dim> in_tool_frame(const Pose<Dim>& pose, const SurfacePoint<Dim>& point, const Param<Dim>& m) {
  return pose.R.transpose() * (point.E * m);
}
/// Slip of a node since its origin, in the tangents E at its place [length]. @param size of its tool, see Pose
template <int Dim>
Param<Dim> slip_of(const ContactModel<Dim>& model, const ContactNode<Dim>& node, double size) {
  return size * model.tools[node.tool]->surface().slip(node.slip_origin, node.place);
}

/// Force of the tool on a contact node and its parts [force].
template <int Dim> struct NodalForce {
  Vector<Dim> F;
  SurfaceForce<Dim> part;
};
/// @param R internal minus external nodal force of the candidate; of a constrained one only the free components
/// count: F = N n + T with the N and the T along slip_space that they need
template <int Dim>
NodalForce<Dim> nodal_force(const ContactModel<Dim>& model, int candidate, const SurfacePoint<Dim>& p,
                            const Vector<Dim>& R);

/// Displacement of a candidate per unit of motion along the normal that its constraints admit: n itself, or the free
/// components of n over their squared length, so that n . admissible = 1; zero where n is across the free ones.
template <int Dim>
Vector<Dim> admissible_normal(const ContactModel<Dim>& model, int candidate, const Vector<Dim>& n);
/// Projector onto the directions along the tool that a candidate's supports leave it, in the tangents E at p: the
/// identity, or of a node on a symmetry plane that of one direction; zero where it cannot slip.
template <int Dim>
Curvature<Dim> slip_space(const ContactModel<Dim>& model, int candidate, const SurfacePoint<Dim>& p);
/// What brings a candidate at x onto the tool at p: the difference, or for a constrained candidate the gap along its
/// admissible normal and the part along its slip_space.
template <int Dim>
Vector<Dim> offset_to(const ContactModel<Dim>& model, int candidate, const SurfacePoint<Dim>& p,
                      const Vector<Dim>& x);

} // namespace burnish

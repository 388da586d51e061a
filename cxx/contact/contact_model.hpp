#pragma once
// What may touch what: candidate nodes, tools, friction; and the plain data of a contact state.
#include "contact/friction.hpp"
#include "kinematics/tool.hpp"
#include <array>
#include <memory>
#include <vector>

namespace burnish {

/// States of a boundary node (method.md section 4). TOUCHED: came into contact at the last event, neither
/// stick nor slip decided. LEAVING: released at the last event, its rest reaction still to be taken off.
/// RECEDING: released, the touch test passes over it while it moves away.
enum class NodeState : char { FREE, TOUCHED, SLIDING, STICKING, LEAVING, RECEDING };
const char* name_of(NodeState state);
inline bool in_contact(NodeState s) {
  return s == NodeState::TOUCHED || s == NodeState::SLIDING || s == NodeState::STICKING;
}
/// A touched node is held like a sticking one until the next test.
inline bool holds(NodeState s) { return s == NodeState::TOUCHED || s == NodeState::STICKING; }

template <int Dim> struct ContactNode {
  NodeState state = NodeState::FREE;
  int tool = -1;                         ///< tool in contact (or nearest one), index into ContactModel::tools
  Param<Dim> s = Param<Dim>::Zero();     ///< parameter of the contact point on the tool
  Param<Dim> s_ref = Param<Dim>::Zero(); ///< where it sticks; slip of the step is counted from here
  double slip_sign = 0;                  ///< sign of ds while sliding, 0 otherwise
  double slip_rate = 0;                  ///< ds/dt of the last step times |X_s| [length/time]
  double area = 1; ///< share of the surface at the start of the step, see FrictionLaw [length or area]
};

/// Plain data, can be written and read.
template <int Dim> struct ContactState {
  std::vector<ContactNode<Dim>> nodes; ///< one per candidate
  Eigen::VectorXd q;                   ///< coordinates of all tools, one after another
};

/// Prescribed values at the end of a step, one per coordinate of all tools.
struct Program {
  std::vector<char> is_motion; ///< 1: q^k = value; 0: generalized force Q_k on the tool = value
  Eigen::VectorXd value;
};

/// Nodes on a symmetry line: components of their displacement that are given. Contact acts along the free
/// ones only, without friction (the support takes what is across it), and the node slides as it must.
template <int Dim> using HeldComponents = std::array<bool, Dim>;

template <int Dim> struct ContactModel {
  std::vector<int> candidates; ///< mesh nodes that may touch a tool
  std::vector<std::shared_ptr<const Tool<Dim>>> tools;
  std::vector<std::shared_ptr<const FrictionLaw>> friction; ///< one per tool
  std::vector<int> first;                ///< first coordinate of each tool in q; last entry: total
  std::vector<HeldComponents<Dim>> held; ///< per candidate; empty: none is held
  std::vector<std::vector<char>> reach;  ///< per tool and candidate: may touch; empty: every candidate

  bool is_held(int candidate) const;
  bool may_touch(int candidate, int tool) const;
  /// Friction between a candidate and a tool: none where the candidate is held.
  const FrictionLaw& law(int candidate, int tool) const;
  int num_coordinates() const { return first.empty() ? 0 : first.back(); }
  Eigen::VectorXd tool_q(const Eigen::VectorXd& q, int tool) const {
    return q.segment(first[tool], first[tool + 1] - first[tool]);
  }
  /// "coordinate "x" of tool "roller"" for entry k of q, for messages.
  std::string coordinate(int k) const;
  std::vector<Pose<Dim>> poses(const Eigen::VectorXd& q) const;
  bool symmetric() const; ///< true if no tool has friction
};

/// Nearest tool of a point and the closest point on it; tool -1 and an infinite gap if there is none.
template <int Dim> struct NearestTool {
  int tool = -1;
  ClosestPoint<Dim> foot;
};
/// @param candidate asks only tools that it may touch; -1: all tools
template <int Dim>
NearestTool<Dim> nearest_tool(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses,
                              const Vector<Dim>& x, const ContactNode<Dim>& near, int candidate);

/// Force of the tool on a contact node and its parts along the normal and the tangent [force].
template <int Dim> struct NodalForce {
  Vector<Dim> F;
  double N, T;
};
/// @param R internal minus external nodal force of the candidate; of a held one only the free components
/// count: F = N n with the N that they need
template <int Dim>
NodalForce<Dim> nodal_force(const ContactModel<Dim>& model, int candidate, const SurfacePoint<Dim>& p,
                            const Vector<Dim>& R);

/// Displacement of a candidate per unit of motion along the normal: n itself, or for a held candidate the
/// free components of n over their squared length, so that n . lift = 1; zero where n is across the free ones.
template <int Dim>
Vector<Dim> normal_lift(const ContactModel<Dim>& model, int candidate, const Vector<Dim>& n);
/// What brings a candidate at x onto the tool at p: the difference, or for a held candidate the gap along lift.
template <int Dim>
Vector<Dim> offset_to(const ContactModel<Dim>& model, int candidate, const SurfacePoint<Dim>& p,
                      const Vector<Dim>& x);

} // namespace burnish

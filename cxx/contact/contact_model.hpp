#pragma once
// What may touch what: candidate nodes, tools, friction; and the plain data of a contact state.
#include "contact/friction.hpp"
#include "kinematics/tool.hpp"
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

template <int Dim> struct ContactModel {
  std::vector<int> candidates; ///< mesh nodes that may touch a tool
  std::vector<std::shared_ptr<const Tool<Dim>>> tools;
  std::vector<std::shared_ptr<const FrictionLaw>> friction; ///< one per tool
  std::vector<int> first; ///< first coordinate of each tool in q; last entry: total

  int num_coordinates() const { return first.empty() ? 0 : first.back(); }
  Eigen::VectorXd tool_q(const Eigen::VectorXd& q, int tool) const {
    return q.segment(first[tool], first[tool + 1] - first[tool]);
  }
  std::vector<Pose<Dim>> poses(const Eigen::VectorXd& q) const;
  bool symmetric() const; ///< true if no tool has friction
};

/// Nearest tool of a point and the closest point on it.
template <int Dim> struct NearestTool {
  int tool = -1;
  ClosestPoint<Dim> foot;
};
template <int Dim>
NearestTool<Dim> nearest_tool(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses,
                              const Vector<Dim>& x, const ContactNode<Dim>& near);

} // namespace burnish

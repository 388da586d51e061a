#pragma once
// The state of a contact as plain data: what every candidate does, and where the tools are.
#include "geometry/surface.hpp"
#include "kinematics/coordinate_formula.hpp"

namespace burnish {

/// States of a boundary node (METHOD.md 4.1). TOUCHED: came into contact at the last event, neither stick nor slip
/// decided. LEAVING: released at the last event, its remaining reaction still to be taken off. RECEDING: released, the
/// touch test passes over it while it moves away.
enum class NodeState : char { FREE, TOUCHED, SLIDING, STICKING, LEAVING, RECEDING };
const char* name_of(NodeState state);
inline bool in_contact(NodeState s) {
  return s == NodeState::TOUCHED || s == NodeState::SLIDING || s == NodeState::STICKING;
}
/// A touched node keeps its place like a sticking one until the next test.
inline bool sticks(NodeState s) { return s == NodeState::TOUCHED || s == NodeState::STICKING; }

/// A candidate; its places and directions are in the frame of its tool.
template <int Dim> struct ContactNode {
  NodeState state = NodeState::FREE;
  int tool = -1;                 ///< tool in contact, or the nearest one: index into ContactModel::tools
  SurfacePlace<Dim> place;       ///< contact point on the tool
  SurfacePlace<Dim> slip_origin; ///< where it sticks; the slip of the step is counted from here
  Vector<Dim> slip_direction =
      Vector<Dim>::Zero(); ///< of a node that slides against friction: unit tangent; else zero
  Vector<Dim> slip_memory =
      Vector<Dim>::Zero(); ///< direction at the end of the last step by its weight (contact/mean_slip.hpp)
  bool tied = false;  ///< mid node that follows the slips of the ends of its edge (contact/tied_edges.hpp)
  bool bears = false; ///< a weightless vertex with friction all the same (ContactModel::weightless)
  bool has_ties =
      false;            ///< a weightless vertex that mid nodes are tied to: it has friction, by shared forces
  double slip_rate = 0; ///< slip of the last step along it over the time [length/time]
  double tributary_area = 1; ///< METHOD.md (3.13), at the start of the step [length or area]
};

/// Contact point, and the slip counts from there anew.
template <int Dim> void place_at(ContactNode<Dim>& node, const SurfacePlace<Dim>& place) {
  node.place = node.slip_origin = place;
}
/// From here on the node sticks where its slip was counted from.
template <int Dim> void make_stick(ContactNode<Dim>& node) {
  node.state = NodeState::STICKING;
  node.place = node.slip_origin;
  node.slip_direction.setZero();
}
/// From here on the node slides.
/// @param direction of the slip, tangent in the tool's frame; zero without friction
template <int Dim> void make_slide(ContactNode<Dim>& node, const Vector<Dim>& direction) {
  node.state = NodeState::SLIDING;
  node.slip_direction = direction;
}
template <int Dim> void make_free(ContactNode<Dim>& node) {
  node.state = NodeState::FREE;
  node.tied = node.bears = node.has_ties = false;
  node.slip_direction.setZero();
}

/// Plain data, can be written and read.
template <int Dim> struct ContactState {
  std::vector<ContactNode<Dim>> nodes; ///< one per candidate
  Eigen::VectorXd q;                   ///< coordinates of all tools, one after another
  double slip_stiffness =
      0; ///< c of METHOD.md (3.14), in space [force/length]; 0: directions of slip stay as they are
  bool fixed =
      false; ///< the states of the nodes stay through the step: c of a sliding node is as large as its slip needs
};

/// What the program prescribes at an instant, one value per coordinate of all tools.
struct PrescribedValues {
  std::vector<char> is_motion; ///< 1: q^k = value; 0: generalized force Q_k on the tool = value
  Eigen::VectorXd value;
  /// Per coordinate: the force as a formula, see force_formula, or null; its value counts for nothing then. Empty: none.
  std::vector<std::shared_ptr<const CoordinateFormula>> formula = {};
  double t = 0; ///< time at the end of the step, for the formulas
  /// Per coordinate: 1 if its own force resists it (held_by_drive), it needs no contact then. Empty: none.
  std::vector<char> held = {};
  bool is_held(Eigen::Index k) const { return !held.empty() && held[static_cast<std::size_t>(k)]; }
};

} // namespace burnish

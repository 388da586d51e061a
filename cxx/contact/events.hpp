#pragma once
// Contact events inside a step: everything is linear in the fraction of the step; the earliest one is located
// and all within its tolerance are taken together (METHOD.md 4.2, ALGORITHMS.md 10).
#include "contact/body_view.hpp"
#include "contact/contact_model.hpp"
#include "contact/tolerances.hpp"
#include <algorithm>
#include <string>

namespace burnish {

/// The last three are of quadrature points; USER by a user-defined formula, ContactEvent::name is its name.
enum class EventKind : char {
  TOUCH,
  RELEASE,
  SLIP_TO_STICK,
  STICK_TO_SLIP,
  NEXT_PIECE,
  JUMP, ///< to an equilibrium that is not near: node is that with the largest way, of the mesh
  YIELD,
  UNLOADING,
  USER
};
const char* name_of(EventKind kind);

template <int Dim> struct ContactEvent {
  double t = 0;        ///< instant [time]
  double fraction = 0; ///< of the step, 0..1
  EventKind kind = EventKind::TOUCH;
  int candidate = -1; ///< index into ContactModel::candidates, -1 for element events
  int node = -1;      ///< mesh node, or quadrature point for element events
  int tool = -1;
  Vector<Dim> x = Vector<Dim>::Zero(); ///< place at that instant [length]
  /// STICK_TO_SLIP: direction of the slip, against the tangential force at the end of the step; in the tool's frame
  Vector<Dim> slip_direction = Vector<Dim>::Zero();
  std::string name; ///< USER: the event's name
};

/// What a log calls the event: the name of its kind, or that of a user-defined one.
template <int Dim> std::string kind_of(const ContactEvent<Dim>& event) {
  return event.kind == EventKind::USER ? event.name : name_of(event.kind);
}

/// Both ends of a step that was solved with fixed states. R: internal minus external nodal force.
template <int Dim> struct StepEnds {
  const ContactState<Dim>*start = nullptr, *end = nullptr;
  const Eigen::VectorXd *u_start = nullptr, *u_end = nullptr, *R_start = nullptr, *R_end = nullptr;
  double t_start = 0, dt = 0;
};

/// Tolerances of an event search, and what is left out of it.
struct EventSearch : Tolerances {
  double fraction = 1e-3; ///< events this close to the earliest one are taken with it
  /// Fraction of the step by which a node that begins to slide and slips back is looked at again; 0: it sticks at once
  double closer = 0;
  /// Candidates that must not begin to slide, since nothing else supports their tool; they are released directly.
  std::vector<int> supports = {};
  bool meets_released = false; ///< released nodes may touch again within the step; in pure rates they drift
};

/// All events of the step that lie within the tolerance of the earliest; empty if the whole step is free of
/// events. Fractions are those of linear interpolation; touch fractions are refined on the true gap. An event
/// whose quantity comes within its tolerance at the end of the step, from above, has the fraction 1.
template <int Dim>
std::vector<ContactEvent<Dim>> earliest_events(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                               const StepEnds<Dim>& step, const EventSearch& search);

/// All state changes between two accepted states (implicit stepping). Instants are estimates within the step:
/// a touch where the moving tool meets the place that the node had at the start, the others in the middle of
/// the step (a release at its start if the node was already unloaded). Event stepping locates them.
template <int Dim>
std::vector<ContactEvent<Dim>> state_changes(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                             const StepEnds<Dim>& step);

/// Changes the states of the nodes concerned: touch -> TOUCHED, release -> LEAVING, slip to stick ->
/// STICKING, stick to slip -> SLIDING against the tangential force.
template <int Dim>
void apply_events(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                  const std::vector<ContactEvent<Dim>>& events, const Eigen::VectorXd& u,
                  ContactState<Dim>& state);

/// LEAVING becomes RECEDING; RECEDING becomes FREE once its gap exceeds the tolerance.
template <int Dim>
void settle_released(const ContactModel<Dim>& model, const BodyView<Dim>& body, const Eigen::VectorXd& u,
                     double gap, ContactState<Dim>& state);

} // namespace burnish

#include "contact/events.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {

const char* name_of(EventKind kind) {
  switch (kind) {
  case EventKind::TOUCH:
    return "touch";
  case EventKind::RELEASE:
    return "release";
  case EventKind::SLIP_TO_STICK:
    return "slip-to-stick";
  case EventKind::STICK_TO_SLIP:
    return "stick-to-slip";
  case EventKind::NEXT_PIECE:
    return "next-piece";
  case EventKind::YIELD:
    return "yield";
  case EventKind::UNLOADING:
    return "unloading";
  case EventKind::SCRIPT:
    return "script";
  }
  return "?";
}

namespace {

constexpr double NEVER = std::numeric_limits<double>::infinity();

// Fraction at which a quantity that is linear in the step falls through zero: 0 if it was below from the
// start, 1 if it ends within the tolerance.
double crossing(double start, double end, double tolerance) {
  if (end < -tolerance) return start <= 0 ? 0 : start / (start - end);
  return end <= tolerance && start > tolerance ? 1 : NEVER;
}

// The limit goes on below N = 0, so that a held node that loses its pressure slides where it cannot hold.
template <int Dim> struct Forces { double N, T, limit; };

template <int Dim>
Forces<Dim> forces(const ContactModel<Dim>& model, int candidate, const std::vector<Pose<Dim>>& poses,
                   const ContactNode<Dim>& node, const Eigen::VectorXd& R) {
  const auto p = model.tools[node.tool]->surface(poses[node.tool], node.s);
  const NodalForce<Dim> force =
      nodal_force(model, candidate, p, Vector<Dim>(R.segment<Dim>(Dim * model.candidates[candidate])));
  return {force.N, force.T, model.law(candidate, node.tool).limit(force.N, node.area)};
}

// Fraction at which a free node meets a tool, refined on the true gap by regula falsi.
template <int Dim>
double touch_fraction(const ContactModel<Dim>& model, const BodyView<Dim>& body, const StepEnds<Dim>& step,
                      std::size_t i, double tolerance) {
  const auto gap = [&](double f) {
    const Eigen::VectorXd q = step.start->q + f * (step.end->q - step.start->q);
    const int node = model.candidates[i];
    const Vector<Dim> x = (1 - f) * body.position(*step.u_start, node) + f * body.position(*step.u_end, node);
    return nearest_tool(model, model.poses(q), x, step.start->nodes[i], static_cast<int>(i)).foot.gap;
  };
  double a = 0, b = 1, ga = gap(0), gb = gap(1);
  if (gb >= -tolerance) return crossing(ga, gb, tolerance);
  if (ga <= 0) return 0;
  double f = ga / (ga - gb);
  for (int it = 0; it < 30; ++it) {
    const double g = gap(f);
    if (std::abs(g) <= 0.1 * tolerance) break;
    (g > 0 ? a : b) = f;
    (g > 0 ? ga : gb) = g;
    f = a + (b - a) * ga / (ga - gb);
  }
  return f;
}

// Instant at which the slip rate changes sign: rates are means of steps, so they belong to the middles.
template <int Dim>
double stick_fraction(const ContactNode<Dim>& start, const ContactNode<Dim>& end, double length, double dt,
                      double tolerance) {
  const double slip = (end.s - start.s)[0] * start.slip_sign * length;
  if (slip >= -tolerance) return NEVER;
  const double before = start.slip_rate * start.slip_sign, now = slip / dt;
  if (before <= 0) return 0;
  return std::clamp(1.5 * before / (before - now) - 0.5, 0., 1.);
}

// Fraction just beyond the joint where a sliding node passes to the next piece of its tool's profile; NEVER if
// it stays on its piece.
template <int Dim>
double piece_fraction(const Profile<Dim>& profile, const ContactNode<Dim>& start,
                      const ContactNode<Dim>& end) {
  const int first = profile.piece(start.s);
  if (start.tool != end.tool || profile.piece(end.s) == first) return NEVER;
  double a = 0, b = 1;
  while (b - a > 1e-12) {
    const double middle = 0.5 * (a + b);
    (profile.piece(start.s + middle * (end.s - start.s)) == first ? a : b) = middle;
  }
  return b;
}

template <int Dim>
ContactEvent<Dim> make_event(const BodyView<Dim>& body, const StepEnds<Dim>& step,
                             const ContactModel<Dim>& model, std::size_t i, EventKind kind, double fraction,
                             int tool) {
  ContactEvent<Dim> event;
  const int node = model.candidates[i];
  event.fraction = fraction;
  event.t = step.t_start + fraction * step.dt;
  event.kind = kind;
  event.candidate = static_cast<int>(i);
  event.node = node;
  event.tool = tool;
  event.x = (1 - fraction) * body.position(*step.u_start, node) + fraction * body.position(*step.u_end, node);
  return event;
}

// Earliest event of one candidate, fraction NEVER if none.
template <int Dim>
ContactEvent<Dim> node_event(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                             const StepEnds<Dim>& step, const std::vector<Pose<Dim>>& poses0,
                             const std::vector<Pose<Dim>>& poses1, std::size_t i,
                             const EventTolerance& tolerance, bool support) {
  const ContactNode<Dim>&n0 = step.start->nodes[i], &n1 = step.end->nodes[i];
  const int candidate = static_cast<int>(i);
  if (!in_contact(n0.state)) {
    if (n0.state != NodeState::FREE) return make_event(body, step, model, i, EventKind::TOUCH, NEVER, -1);
    const double f = touch_fraction(model, body, step, i, tolerance.gap);
    return make_event(body, step, model, i, EventKind::TOUCH, f, n0.tool);
  }
  const auto a = forces(model, candidate, poses0, n0, *step.R_start);
  const auto b = forces(model, candidate, poses1, n1, *step.R_end);
  double release = crossing(a.N, b.N, tolerance.force);
  double change = NEVER;
  EventKind kind = EventKind::STICK_TO_SLIP;
  const FrictionLaw& law = model.law(candidate, n0.tool);
  if (n0.state == NodeState::SLIDING) {
    const double length = model.tools[n0.tool]->surface(poses0[n0.tool], n0.s).x_s.col(0).norm();
    kind = EventKind::SLIP_TO_STICK;
    if (!law.frictionless()) change = stick_fraction(n0, n1, length, step.dt, tolerance.gap);
  } else if (!support && !law.sticks_always()) {
    change = crossing(a.limit - std::abs(a.T), b.limit - std::abs(b.T), tolerance.force);
    if (release < NEVER && change == NEVER) change = release; // a sticking node slides before it is released
    release = NEVER;
  }
  const double piece = n0.state == NodeState::SLIDING && in_contact(n1.state)
                           ? piece_fraction(model.tools[n0.tool]->profile(), n0, n1)
                           : NEVER;
  if (piece < std::min(release, change))
    return make_event(body, step, model, i, EventKind::NEXT_PIECE, piece, n0.tool);
  if (release <= change) return make_event(body, step, model, i, EventKind::RELEASE, release, n0.tool);
  auto event = make_event(body, step, model, i, kind, change, n0.tool);
  event.slip_sign = b.T > 0 ? -1 : 1;
  return event;
}

} // namespace

template <int Dim>
std::vector<ContactEvent<Dim>> earliest_events(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                               const StepEnds<Dim>& step, const EventTolerance& tolerance,
                                               const std::vector<int>& supports) {
  const auto poses0 = model.poses(step.start->q), poses1 = model.poses(step.end->q);
  std::vector<ContactEvent<Dim>> found;
  double earliest = NEVER;
  for (std::size_t i = 0; i < model.candidates.size(); ++i) {
    const bool support = std::find(supports.begin(), supports.end(), static_cast<int>(i)) != supports.end();
    const auto event = node_event(model, body, step, poses0, poses1, i, tolerance, support);
    if (!(event.fraction <= 1)) continue;
    earliest = std::min(earliest, event.fraction);
    found.push_back(event);
  }
  std::vector<ContactEvent<Dim>> first;
  for (const auto& event : found)
    if (event.fraction <= earliest + tolerance.fraction) first.push_back(event);
  return first;
}

template <int Dim>
std::vector<ContactEvent<Dim>> state_changes(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                             const StepEnds<Dim>& step) {
  std::vector<ContactEvent<Dim>> changes;
  const auto poses0 = model.poses(step.start->q);
  StepEnds<Dim> resting = step; // the nodes stay, the tools move
  resting.u_end = step.u_start;
  for (std::size_t i = 0; i < model.candidates.size(); ++i) {
    const ContactNode<Dim>&n0 = step.start->nodes[i], &n1 = step.end->nodes[i];
    const bool c0 = in_contact(n0.state), c1 = in_contact(n1.state);
    const auto add = [&](EventKind kind, double f, int tool) {
      changes.push_back(make_event(body, step, model, i, kind, f > 1 ? 1 : f, tool));
    };
    if (!c0 && c1)
      add(EventKind::TOUCH, touch_fraction(model, body, resting, i, 0), n1.tool);
    else if (c0 && !c1) {
      const double N = forces(model, static_cast<int>(i), poses0, n0, *step.R_start).N;
      add(EventKind::RELEASE, N <= 0 ? 0 : 0.5, n0.tool);
    } else if (c0 && c1 && holds(n0.state) != holds(n1.state)) {
      add(holds(n1.state) ? EventKind::SLIP_TO_STICK : EventKind::STICK_TO_SLIP, 0.5, n1.tool);
    }
    if (!c0 || !c1) continue;
    const double piece = piece_fraction(model.tools[n0.tool]->profile(), n0, n1);
    if (piece < NEVER) add(EventKind::NEXT_PIECE, piece, n1.tool);
  }
  return changes;
}

template <int Dim>
void apply_events(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                  const std::vector<ContactEvent<Dim>>& events, const Eigen::VectorXd& u,
                  ContactState<Dim>& state) {
  const auto poses = model.poses(state.q);
  for (const auto& event : events) {
    if (event.candidate < 0 || event.kind == EventKind::NEXT_PIECE) continue;
    ContactNode<Dim>& node = state.nodes[event.candidate];
    const int mesh_node = model.candidates[event.candidate];
    if (event.kind == EventKind::TOUCH) {
      const auto nearest = nearest_tool(model, poses, body.position(u, mesh_node), node, event.candidate);
      node.tool = nearest.tool;
      node.s = nearest.foot.s;
      node.state =
          model.law(event.candidate, node.tool).frictionless() ? NodeState::SLIDING : NodeState::TOUCHED;
      node.slip_sign = 0;
    } else if (event.kind == EventKind::RELEASE) {
      node.state = NodeState::LEAVING;
      node.slip_sign = 0;
    } else if (event.kind == EventKind::SLIP_TO_STICK) {
      node.state = NodeState::STICKING;
      node.slip_sign = 0;
    } else if (event.kind == EventKind::STICK_TO_SLIP) {
      node.state = NodeState::SLIDING;
      node.slip_sign = event.slip_sign;
    }
    node.s_ref = node.s;
    node.slip_rate = 0;
  }
}

template <int Dim>
void settle_released(const ContactModel<Dim>& model, const BodyView<Dim>& body, const Eigen::VectorXd& u,
                     double gap, ContactState<Dim>& state) {
  const auto poses = model.poses(state.q);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    ContactNode<Dim>& node = state.nodes[i];
    if (node.state == NodeState::LEAVING) node.state = NodeState::RECEDING;
    if (node.state != NodeState::RECEDING) continue;
    const Vector<Dim> x = body.position(u, model.candidates[i]);
    const double now = nearest_tool(model, poses, x, node, static_cast<int>(i)).foot.gap;
    if (now > gap || now < -gap) node.state = NodeState::FREE;
  }
}

template std::vector<ContactEvent<2>> earliest_events<2>(const ContactModel<2>&, const BodyView<2>&,
                                                         const StepEnds<2>&, const EventTolerance&,
                                                         const std::vector<int>&);
template std::vector<ContactEvent<2>> state_changes<2>(const ContactModel<2>&, const BodyView<2>&,
                                                       const StepEnds<2>&);
template void apply_events<2>(const ContactModel<2>&, const BodyView<2>&, const std::vector<ContactEvent<2>>&,
                              const Eigen::VectorXd&, ContactState<2>&);
template void settle_released<2>(const ContactModel<2>&, const BodyView<2>&, const Eigen::VectorXd&, double,
                                 ContactState<2>&);

} // namespace burnish

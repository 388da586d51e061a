#include "contact/events.hpp"
#include "contact/tied_edges.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {

const char* name_of(EventKind kind) {
  static constexpr const char* NAMES[] = {"touch", "release", "slip-to-stick", "stick-to-slip", "next-piece",
                                          "jump",  "yield",   "unloading",     "user"};
  return NAMES[static_cast<int>(kind)];
}

namespace {

constexpr double NEVER = std::numeric_limits<double>::infinity();

// Fraction at which a quantity that is linear in the step falls through zero: 0 if it was below from the
// start, 1 if it ends within the tolerance.
double crossing(double start, double end, double tolerance) {
  if (end < -tolerance) return start <= 0 ? 0 : start / (start - end);
  return end <= tolerance && start > tolerance ? 1 : NEVER;
}

// What decides the events of a node in contact at one end of the step.
template <int Dim> struct Forces {
  SurfaceForce<Dim> force;
  Param<Dim> m; ///< direction of its slip
  SurfacePoint<Dim> point;
};

template <int Dim>
Forces<Dim> forces(const ContactModel<Dim>& model, int candidate, const std::vector<Pose<Dim>>& poses,
                   const ContactNode<Dim>& node, const Eigen::VectorXd& R) {
  const ContactPoint<Dim> at = contact_point(model, poses, node);
  const Vector<Dim> Rn = R.segment<Dim>(Dim * model.candidates[candidate]);
  const SurfaceForce<Dim> force = nodal_force(model, candidate, at.surface, Rn).part;
  return {force, at.m, at.surface};
}

// Deciding forces at both ends of the step, with the ties of the step.
template <int Dim> struct BothEnds {
  std::vector<Pose<Dim>> poses0, poses1;
  std::vector<DecidingForce<Dim>> deciding0, deciding1;
};
template <int Dim> BothEnds<Dim> both_ends(const ContactModel<Dim>& model, const StepEnds<Dim>& step) {
  BothEnds<Dim> ends{model.poses(step.start->q), model.poses(step.end->q), {}, {}};
  ContactState<Dim> start = *step.start;
  for (std::size_t i = 0; i < start.nodes.size(); ++i) start.nodes[i].tied = step.end->nodes[i].tied;
  ends.deciding0 = deciding_forces(model, start, ends.poses0, *step.R_start);
  ends.deciding1 = deciding_forces(model, *step.end, ends.poses1, *step.R_end);
  return ends;
}

// Fraction at which a node that is not in contact meets a tool, refined on the true gap by regula falsi. One that was released
// is passed over in both bands of the tolerance around the surface: it meets the tool where it leaves them on the inner side.
template <int Dim>
double touch_fraction(const ContactModel<Dim>& model, const BodyView<Dim>& body, const StepEnds<Dim>& step,
                      std::size_t i, double tolerance) {
  const bool released =
      step.start->nodes[i].state != NodeState::FREE && !in_contact(step.start->nodes[i].state);
  const double margin = released ? tolerance : 0;
  const auto gap = [&](double f) {
    const Eigen::VectorXd q = step.start->q + f * (step.end->q - step.start->q);
    const int node = model.candidates[i];
    const Vector<Dim> x = (1 - f) * body.position(*step.u_start, node) + f * body.position(*step.u_end, node);
    return nearest_tool(model, model.poses(q), x, step.start->nodes[i], static_cast<int>(i)).foot.gap +
           margin;
  };
  double a = 0, b = 1, ga = gap(0), gb = gap(1);
  if (released && (ga <= 0 || gb >= 0)) return NEVER;
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

// Fraction at which a sticking node leaves the cone. In space T turns: |T0 + f (T1 - T0)| = g0 + f (g1 - g0), METHOD.md (4.1a).
template <int Dim>
double slip_fraction(const TangentialLaw<Dim>& law, const DecidingForce<Dim>& start,
                     const DecidingForce<Dim>& end, double tolerance) {
  const double reserve0 = law.reserve(start), reserve1 = law.reserve(end);
  const double f = crossing(reserve0, reserve1, tolerance);
  if (Dim == 2 || !(f > 0 && f < 1)) return f;
  const Param<Dim>&T = start.force.T, dT = end.force.T - T;
  const double g = reserve0 + T.norm(), dg = reserve1 + end.force.T.norm() - g;
  const double a = dT.squaredNorm() - dg * dg, b = T.dot(dT) - g * dg, c = T.squaredNorm() - g * g;
  return -c / (b + std::sqrt(std::max(b * b - a * c, 0.))); // c < 0: the first root above zero
}

// Instant at which the slip rate changes sign: rates are means of steps, so they belong to the middles.
// A node that begins to slide has no rate before: the step has to become shorter.
// @param slip of the step; @param m its direction, in the same tangents
template <int Dim>
double stick_fraction(const ContactNode<Dim>& start, const Param<Dim>& slip, const Param<Dim>& m, double dt,
                      const EventSearch& tolerance) {
  if (!TangentialLaw<Dim>::slips_back(slip, m, tolerance.slip_of(start.tool))) return NEVER;
  const double before = start.slip_rate, now = TangentialLaw<Dim>::advance(slip, m) / dt;
  if (before == 0) return tolerance.closer;
  if (before < 0) return 0;
  return std::clamp(1.5 * before / (before - now) - 0.5, 0., 1.);
}

template <int Dim>
ContactEvent<Dim> make_event(const BodyView<Dim>& body, const StepEnds<Dim>& step,
                             const ContactModel<Dim>& model, std::size_t i, EventKind kind, double fraction) {
  ContactEvent<Dim> event;
  const int node = model.candidates[i];
  event.fraction = fraction;
  event.t = step.t_start + fraction * step.dt;
  event.kind = kind;
  event.candidate = static_cast<int>(i);
  event.node = node;
  event.tool = step.start->nodes[i].tool;
  event.x = (1 - fraction) * body.position(*step.u_start, node) + fraction * body.position(*step.u_end, node);
  return event;
}

// Earliest event of a candidate in contact, fraction NEVER if none.
template <int Dim>
ContactEvent<Dim> contact_event(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                const StepEnds<Dim>& step, const BothEnds<Dim>& ends, std::size_t i,
                                const EventSearch& tolerance) {
  const ContactNode<Dim>&n0 = step.start->nodes[i], &n1 = step.end->nodes[i];
  const int candidate = static_cast<int>(i);
  const std::vector<int>& supports = tolerance.supports;
  const bool support = std::find(supports.begin(), supports.end(), candidate) != supports.end();
  const auto a = forces(model, candidate, ends.poses0, n0, *step.R_start);
  const auto b = forces(model, candidate, ends.poses1, n1, *step.R_end);
  const TangentialLaw<Dim>& law = model.law(candidate, n0);
  const Surface<Dim>& surface = model.tools[n0.tool]->surface();
  const bool weightless = model.is_weightless(candidate);
  const double N0 = weightless ? ends.deciding0[i].normal : a.force.N,
               N1 = weightless ? ends.deciding1[i].normal : b.force.N;
  double release = crossing(N0, N1, tolerance.force_of(n0.tool)), change = NEVER;
  EventKind kind = EventKind::STICK_TO_SLIP;
  if (n1.tied) {
    // only released: its ends decide over stick and slip
  } else if (n0.state == NodeState::SLIDING) {
    kind = EventKind::SLIP_TO_STICK;
    const bool plane = Dim == 2; // in space the power of friction, whose direction turns, at the end
    const Param<Dim> own =
        plane ? Param<Dim>(-surface.slip(n1.place, n0.place)) : surface.slip(n0.place, n1.place);
    const Param<Dim> slip = ends.poses1[n0.tool].size * own;
    if (!law.frictionless()) change = stick_fraction(n0, slip, plane ? a.m : b.m, step.dt, tolerance);
  } else if (!support && !law.friction().sticks_always()) {
    change = slip_fraction(law, ends.deciding0[i], ends.deciding1[i], tolerance.force_of(n0.tool));
    if (release < NEVER && change == NEVER) change = release; // a sticking node slides before it is released
    release = NEVER;
  }
  double passage = NEVER;
  if (n0.state == NodeState::SLIDING && in_contact(n1.state) && n0.tool == n1.tool)
    passage = surface.passage(n0.place, n1.place);
  if (passage < std::min(release, change))
    return make_event(body, step, model, i, EventKind::NEXT_PIECE, passage);
  if (release <= change) return make_event(body, step, model, i, EventKind::RELEASE, release);
  auto event = make_event(body, step, model, i, kind, change);
  event.slip_direction =
      in_tool_frame(ends.poses1[n0.tool], b.point, law.slip_against(ends.deciding1[i].force.T));
  return event;
}

// Earliest event of any candidate.
template <int Dim>
ContactEvent<Dim> node_event(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                             const StepEnds<Dim>& step, const BothEnds<Dim>& ends, std::size_t i,
                             const EventSearch& tolerance) {
  const ContactNode<Dim>& node = step.start->nodes[i];
  if (in_contact(node.state)) return contact_event(model, body, step, ends, i, tolerance);
  const bool open = node.state == NodeState::FREE || tolerance.meets_released;
  return make_event(body, step, model, i, EventKind::TOUCH,
                    open ? touch_fraction(model, body, step, i, tolerance.gap) : NEVER);
}

} // namespace

template <int Dim>
std::vector<ContactEvent<Dim>> earliest_events(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                               const StepEnds<Dim>& step, const EventSearch& tolerance) {
  const BothEnds<Dim> ends = both_ends(model, step);
  std::vector<ContactEvent<Dim>> found;
  double earliest = NEVER;
  for (std::size_t i = 0; i < model.candidates.size(); ++i) {
    const auto event = node_event(model, body, step, ends, i, tolerance);
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
      changes.push_back(make_event(body, step, model, i, kind, f > 1 ? 1 : f));
      changes.back().tool = tool;
    };
    if (!c0 && c1)
      add(EventKind::TOUCH, touch_fraction(model, body, resting, i, 0), n1.tool);
    else if (c0 && !c1) {
      const double N = forces(model, static_cast<int>(i), poses0, n0, *step.R_start).force.N;
      add(EventKind::RELEASE, N <= 0 ? 0 : 0.5, n0.tool);
    } else if (c0 && c1 && !n1.tied && sticks(n0.state) != sticks(n1.state)) {
      add(sticks(n1.state) ? EventKind::SLIP_TO_STICK : EventKind::STICK_TO_SLIP, 0.5, n1.tool);
    }
    if (!c0 || !c1 || n0.tool != n1.tool) continue;
    const double passage = model.tools[n0.tool]->surface().passage(n0.place, n1.place);
    if (passage < NEVER) add(EventKind::NEXT_PIECE, passage, n1.tool);
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
      node.place = nearest.foot.place;
      node.state =
          model.law(event.candidate, node.tool).frictionless() ? NodeState::SLIDING : NodeState::TOUCHED;
      node.slip_direction.setZero();
    }
    place_at(node, node.place); // slip counts from here
    node.slip_rate = 0;
    if (event.kind == EventKind::RELEASE) {
      make_free(node);
      node.state = NodeState::LEAVING;
    } else if (event.kind == EventKind::SLIP_TO_STICK) {
      make_stick(node);
    } else if (event.kind == EventKind::STICK_TO_SLIP) {
      make_slide(node, event.slip_direction);
    }
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

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template std::vector<ContactEvent<Dim>> earliest_events<Dim>(                                              \
      const ContactModel<Dim>&, const BodyView<Dim>&, const StepEnds<Dim>&, const EventSearch&);             \
  template std::vector<ContactEvent<Dim>> state_changes<Dim>(const ContactModel<Dim>&, const BodyView<Dim>&, \
                                                             const StepEnds<Dim>&);                          \
  template void apply_events<Dim>(const ContactModel<Dim>&, const BodyView<Dim>&,                            \
                                  const std::vector<ContactEvent<Dim>>&, const Eigen::VectorXd&,             \
                                  ContactState<Dim>&);                                                       \
  template void settle_released<Dim>(const ContactModel<Dim>&, const BodyView<Dim>&, const Eigen::VectorXd&, \
                                     double, ContactState<Dim>&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish

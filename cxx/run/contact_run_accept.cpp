// The end of a step of a run: events within it, what is accepted, and the way back.
#include "base/error.hpp"
#include "contact/resultant.hpp"
#include "contact/slip_motion.hpp"
#include "contact/tool_support.hpp"
#include "run/contact_motion.hpp"
#include <algorithm>

namespace burnish {
namespace {

constexpr double CLOSER = 0.25; // EventSearch::closer of event steps with tied edges

} // namespace

template <int Dim>
StepEnds<Dim> ContactRun<Dim>::ends(const Eigen::VectorXd& u, const Eigen::VectorXd& R) const {
  return {
      &m_accepted.contact, &m_iteration.state(), &m_step.u_start, &u, &m_accepted.R, &R, m_step.t, m_step.dt};
}

template <int Dim>
std::vector<ContactEvent<Dim>> ContactRun<Dim>::events(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                                       double tolerance, double until) const {
  m_step.require_begun("contact.events");
  require(tolerance >= 0, "contact.events", "tolerance", tolerance, ">= 0");
  const auto& options = m_iteration.options();
  const double h = m_setup->body().spacing, least = std::numeric_limits<double>::min();
  EventSearch search;
  search.force = options.tolerance * std::max(m_iteration.balance().memory().scale, least);
  search.gap = search.slip = options.gap_tolerance * h;
  search.fraction = tolerance;
  search.tool_force = m_iteration.balance().tolerances().tool_force.cwiseMax(least);
  if (m_step.stepping != Stepping::RATES) {
    search.compliance = m_corrector.compliance();
    search.meets_released = true;
    if (options.tied && Dim == 2) search.closer = CLOSER;
  } else { // pure rates do not let them go, see support_after_events
    search.supports = sole_supports(m_setup->model(), m_step.prescribed, m_accepted.contact);
  }
  const Eigen::VectorXd balance = m_loads.residual(u, m_step.end(), R);
  auto found = earliest_events(m_setup->model(), m_setup->body(), ends(u, balance), search);
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const auto& event) { return event.fraction > until + tolerance; }),
              found.end());
  return found;
}

template <int Dim>
void ContactRun<Dim>::take_events(const std::vector<ContactEvent<Dim>>& events, const Eigen::VectorXd& u,
                                  ContactState<Dim>& state) const {
  apply_events(m_setup->model(), m_setup->body(), events, u, state); // released now: leaves in the next step
  support_after_events(m_setup->model(), m_step.prescribed, events, m_step.stepping != Stepping::RATES,
                       state);
}

template <int Dim>
void ContactRun<Dim>::accept(const Eigen::VectorXd& u, const Eigen::VectorXd& internal,
                             const std::vector<ContactEvent<Dim>>& events) {
  m_step.require_checked("contact.accept");
  require(u.size() == m_accepted.u.size() && internal.size() == m_accepted.u.size(), "contact.accept",
          "size of the arrays", u.size(), "number of dofs");
  const Eigen::VectorXd R = m_loads.residual(u, m_step.end(), internal);
  ContactState<Dim>& state = m_iteration.state();
  EventLog<Dim>& log = m_accepted.log;
  log.add(m_step.log.events);
  if (m_step.stepping == Stepping::IMPLICIT)
    log.add(state_changes(m_setup->model(), m_setup->body(), ends(u, R)));
  measure_slips(m_setup->model(), m_step.dt, R, state);
  const bool own = m_step.ways.own_nearer(u, m_accepted.history.own);
  m_accepted.history = {u - m_step.u_start, state.q - m_accepted.contact.q, m_accepted.contact.q, m_step.dt,
                        own};
  m_accepted.u = u;
  m_accepted.R = R;
  if (m_step.stepping == Stepping::RATES) {
    m_iteration.balance().look(state, m_iteration.prescribed(), u, R);
    m_iteration.balance().remember();
  }
  if (m_step.stepping != Stepping::IMPLICIT) {
    settle_released(m_setup->model(), m_setup->body(), u,
                    m_iteration.options().gap_tolerance * m_setup->body().spacing, state);
    take_events(events, u, state);
    log.add(events);
  }
  const Eigen::VectorXd& force = m_iteration.balance().last().generalized_force;
  for (Eigen::Index k = 0; k < force.size(); ++k)
    if (!m_setup->model().coupling_of(static_cast<int>(k))) // what follows hands its force on
      m_accepted.jumps.work += 0.5 * (m_accepted.generalized_force[k] + force[k]) * m_accepted.history.dq[k];
  take_areas(state, u);
  m_accepted.contact = state;
  for (int t = 0; t < static_cast<int>(m_accepted.references.size()); ++t)
    m_accepted.references[t] =
        m_setup->model().tools[t]->coordinates().reference_at(m_setup->model().tool_q(state.q, t));
  m_accepted.generalized_force = force;
  m_accepted.load = m_iteration.balance().memory();
  m_accepted.factor = m_corrector.memory();
  m_accepted.factor.tangent =
      nullptr; // state() shares it; kept here, the next factor could not take its place
  m_accepted.prescribed = m_step.prescribed;
  m_accepted.left_out = burnish::left_out(*this);
  m_accepted.support_displacement = m_loads.supports.displacement();
  m_accepted.support_origin = m_loads.supports.origin();
  m_accepted.external = m_loads.external.acting();
  m_accepted.external_lost = false;
  m_loads.hold.accept(u, m_step.end(), m_iteration.balance().memory().scale);
  m_corrector.accepted();
  m_step.log.events.clear();
  m_step.stage = StepUnderWay<Dim>::Stage::NONE;
  update_tools();
}

template <int Dim> void ContactRun<Dim>::accept_events(const std::vector<ContactEvent<Dim>>& events) {
  m_step.require_begun("contact.acceptevents");
  take_events(events, m_step.u_start, m_accepted.contact);
  m_accepted.log.add(events);
  m_accepted.log.add(m_step.log.events);
  m_step.log.events.clear();
}

template <int Dim> void ContactRun<Dim>::add_jump(const Eigen::VectorXd& before, double dissipated) {
  JumpMemory& jumps = m_accepted.jumps;
  ++jumps.number;
  jumps.dissipated += dissipated;
  ContactEvent<Dim> event;
  event.t = m_step.end();
  event.fraction = 1;
  event.kind = EventKind::JUMP;
  double most = -1;
  for (int node = 0; node < m_setup->mesh().num_nodes; ++node) {
    const double way = (m_accepted.u - before).template segment<Dim>(Dim * node).norm();
    if (way > most) event.node = node;
    most = std::max(most, way);
  }
  event.x = m_setup->body().position(m_accepted.u, event.node);
  m_accepted.log.add({event});
}

template <int Dim> void ContactRun<Dim>::revert() {
  m_iteration.state() = m_accepted.contact;
  LoadMemory& load = m_iteration.balance().memory();
  if (m_step.stepping == Stepping::IMPLICIT) {
    load = m_accepted.load;
    m_corrector.restore(m_accepted.factor);
  } else { // an event step only becomes shorter: its factor serves on
    load.scale = m_accepted.load.scale;
    load.tools = m_accepted.load.tools;
  }
  m_step.log.events.clear();
  m_step.stage = StepUnderWay<Dim>::Stage::NONE;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template StepEnds<Dim> ContactRun<Dim>::ends(const Eigen::VectorXd&, const Eigen::VectorXd&) const;        \
  template std::vector<ContactEvent<Dim>> ContactRun<Dim>::events(                                           \
      const Eigen::VectorXd&, const Eigen::VectorXd&, double, double) const;                                 \
  template void ContactRun<Dim>::accept(const Eigen::VectorXd&, const Eigen::VectorXd&,                      \
                                        const std::vector<ContactEvent<Dim>>&);                              \
  template void ContactRun<Dim>::add_jump(const Eigen::VectorXd&, double);                                   \
  template void ContactRun<Dim>::accept_events(const std::vector<ContactEvent<Dim>>&);                       \
  template void ContactRun<Dim>::revert();
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish

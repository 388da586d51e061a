// The end of a step of a run: events within it, what is accepted, and the way back.
#include "base/error.hpp"
#include "contact/resultant.hpp"
#include "contact/slip_motion.hpp"
#include "contact/tool_support.hpp"
#include "stepping/contact_run.hpp"
#include <algorithm>

namespace burnish {
namespace {

constexpr double CLOSER = 0.25; // EventTolerance::closer of event steps with tied edges

} // namespace

template <int Dim>
StepEnds<Dim> ContactRun<Dim>::ends(const Eigen::VectorXd& u, const Eigen::VectorXd& R) const {
  return {&m_accepted.contact, &m_corrector.state(), &m_u_start, &u, &m_accepted.R, &R, m_t, m_dt};
}

template <int Dim>
std::vector<ContactEvent<Dim>> ContactRun<Dim>::events(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                                       double tolerance, double until) const {
  require_begun("contact.events");
  require(tolerance >= 0, "contact.events", "tolerance", tolerance, ">= 0");
  const auto& options = m_corrector.options();
  const double h = body().spacing, least = std::numeric_limits<double>::min();
  EventTolerance tolerances{options.tolerance * std::max(m_corrector.load_scale(), least),
                            options.gap_tolerance * h, tolerance,
                            m_corrector.tool_tolerance().cwiseMax(least)};
  std::vector<int> supports; // pure rates do not let them go, see support_after_events
  if (m_stepping != Stepping::RATES) {
    tolerances.compliance = m_corrector.compliance();
    if (options.tied) tolerances.closer = CLOSER;
  } else
    supports = sole_supports(model(), m_prescribed, m_accepted.contact);
  auto found = earliest_events(model(), body(), ends(u, R), tolerances, supports);
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const auto& event) { return event.fraction > until + tolerance; }),
              found.end());
  return found;
}

template <int Dim>
void ContactRun<Dim>::take_events(const std::vector<ContactEvent<Dim>>& events, const Eigen::VectorXd& u,
                                  ContactState<Dim>& state) const {
  apply_events(model(), body(), events, u, state); // released now: leaves in the next step
  support_after_events(model(), m_prescribed, events, m_stepping != Stepping::RATES, state);
}

// Force over way of the coordinates in the accepted step, and what is to be said of it.
template <int Dim>
void ContactRun<Dim>::follow_drives(const PrescribedValues& old, const Eigen::VectorXd& R) {
  Eigen::VectorXd contact(static_cast<Eigen::Index>(m_setup->tools().size()));
  for (Eigen::Index tool = 0; tool < contact.size(); ++tool) {
    const Eigen::VectorXd f = contact_forces(model(), m_accepted.contact, R, static_cast<int>(tool));
    contact[tool] = f.reshaped(Dim, f.size() / Dim).rowwise().sum().norm();
  }
  m_accepted.drives.add(*m_setup, m_accepted.history.q_old, m_accepted.contact.q, old, m_prescribed,
                        m_accepted.generalized_force, contact, t_end());
  if (m_hold.acts(t_end())) return;
  const std::string branch = m_accepted.drives.unstable(*m_setup, m_corrector.options());
  if (!branch.empty())
    m_accepted.warnings.add("falling force", branch, t_end(), {}, m_accepted.drives.branch_way());
}

template <int Dim>
void ContactRun<Dim>::accept(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                             const std::vector<ContactEvent<Dim>>& events) {
  require_checked("contact.accept");
  require(u.size() == m_accepted.u.size() && R.size() == m_accepted.u.size(), "contact.accept",
          "size of the arrays", u.size(), "number of dofs");
  ContactState<Dim>& state = m_corrector.state();
  EventLog<Dim>& log = m_accepted.log;
  log.add(m_log.events);
  if (m_stepping == Stepping::IMPLICIT) log.add(state_changes(model(), body(), ends(u, R)));
  measure_slips(model(), m_dt, state);
  m_accepted.history = {u - m_u_start, state.q - m_accepted.contact.q, m_accepted.contact.q, m_dt};
  m_accepted.u = u;
  m_accepted.R = R;
  if (m_stepping == Stepping::RATES) m_corrector.measure(u, R);
  if (m_stepping != Stepping::IMPLICIT) {
    settle_released(model(), body(), u, m_corrector.options().gap_tolerance * body().spacing, state);
    take_events(events, u, state);
    log.add(events);
  }
  m_accepted.warnings.check_conflicts(*m_setup, state, u, t_end());
  m_accepted.warnings.check_ends(*m_setup, state, u, t_end());
  take_areas(state, u);
  m_accepted.contact = state;
  m_accepted.generalized_force = m_corrector.last_balance().generalized_force;
  m_accepted.corrector = m_corrector.memory();
  m_accepted.corrector.tangent =
      nullptr; // state() shares it; kept here, the next factor could not take its place
  follow_drives(m_accepted.prescribed, R);
  m_accepted.prescribed = m_prescribed;
  m_accepted.left_out = left_out();
  m_accepted.support_displacement = m_supports.displacement();
  m_hold.accept(u, t_end(), m_corrector.load_scale());
  m_corrector.accepted();
  m_log.events.clear();
  m_stage = Stage::NONE;
  update_tools();
}

template <int Dim> void ContactRun<Dim>::accept_events(const std::vector<ContactEvent<Dim>>& events) {
  require_begun("contact.acceptevents");
  take_events(events, m_u_start, m_accepted.contact);
  m_accepted.log.add(events);
  m_accepted.log.add(m_log.events);
  m_log.events.clear();
}

template <int Dim> void ContactRun<Dim>::revert() {
  m_corrector.state() = m_accepted.contact;
  if (m_stepping == Stepping::IMPLICIT) {
    m_corrector.restore(m_accepted.corrector);
    m_corrector.drop_factor();
  } else // an event step only becomes shorter: its factor serves on
    m_corrector.set_load_scale(m_accepted.corrector.load_scale, m_accepted.corrector.tool_load);
  m_log.events.clear();
  m_stage = Stage::NONE;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template StepEnds<Dim> ContactRun<Dim>::ends(const Eigen::VectorXd&, const Eigen::VectorXd&) const;        \
  template std::vector<ContactEvent<Dim>> ContactRun<Dim>::events(                                           \
      const Eigen::VectorXd&, const Eigen::VectorXd&, double, double) const;                                 \
  template void ContactRun<Dim>::follow_drives(const PrescribedValues&, const Eigen::VectorXd&);             \
  template void ContactRun<Dim>::accept(const Eigen::VectorXd&, const Eigen::VectorXd&,                      \
                                        const std::vector<ContactEvent<Dim>>&);                              \
  template void ContactRun<Dim>::accept_events(const std::vector<ContactEvent<Dim>>&);                       \
  template void ContactRun<Dim>::revert();
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish

#include "run/run_body.hpp"
#include "base/error.hpp"
#include <utility>

namespace burnish {

template <int Dim> void RunBody<Dim>::set_state(const BodyState<Dim>& state) {
  const PointEventsState before = m_user.state();
  m_user.set_state(state.user);
  try {
    m_workpiece->set_state(state.workpiece);
  } catch (...) {
    m_user.set_state(before);
    throw;
  }
  m_step_error = state.step_error;
  m_pending.clear();
  start();
}

template <int Dim>
void RunBody<Dim>::replace(std::unique_ptr<Workpiece<Dim>> workpiece, const std::vector<int>& origin) {
  m_user.take_points(origin);
  m_workpiece = std::move(workpiece);
  m_pending.clear();
  start();
}

template <int Dim> void RunBody<Dim>::accept() {
  add_step_error(*m_workpiece, m_step_error);
  std::vector<ElementEvent<Dim>> acting;
  if (!m_damage.empty()) acting = m_user.find(*m_workpiece);
  m_user.accept(*m_workpiece);
  m_workpiece->accept();
  m_damage.apply(acting, *m_workpiece);
  m_accepted = true;
}

template <int Dim> void RunBody<Dim>::revert() {
  m_user.revert();
  m_workpiece->revert();
  m_reverted = true;
}

template <int Dim> void RunBody<Dim>::start() {
  if (m_workpiece->user_defined() && m_damage.heals())
    fail("RunBody",
         "an event heals, expected damage only: the law is user-defined, the stress that it keeps cannot be "
         "forgotten");
  m_accepted = false;
  m_reverted = true;
}

template <int Dim> StateChange RunBody<Dim>::take_change() {
  if (!m_workpiece->user_defined()) return StateChange::NONE;
  if (std::exchange(m_accepted, false)) return StateChange::ACCEPTED;
  return std::exchange(m_reverted, false) ? StateChange::REVERTED : StateChange::NONE;
}

template <int Dim> double RunBody<Dim>::find_earliest(double tolerance, double noise) {
  m_pending = earliest(element_events(*m_workpiece, tolerance, noise), tolerance);
  return first_fraction(m_pending);
}

template <int Dim> void RunBody<Dim>::find_all() { m_pending = element_events(*m_workpiece, 0); }

template <int Dim> long RunBody<Dim>::accept_events() {
  burnish::accept_events(m_pending, *m_workpiece);
  const auto n = static_cast<long>(m_pending.size());
  m_pending.clear();
  return n;
}

template <int Dim> double RunBody<Dim>::find_earliest_user(double overshoot, double least) {
  m_user.set_overshoot(overshoot);
  return m_user.earliest(*m_workpiece, least);
}

template <int Dim> std::vector<ElementEvent<Dim>> RunBody<Dim>::user_events() const {
  return m_user.find(*m_workpiece);
}

template class RunBody<2>;
template class RunBody<3>;

} // namespace burnish

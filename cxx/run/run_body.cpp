#include "run/run_body.hpp"
#include "base/error.hpp"
#include "workpiece/point_fields.hpp"
#include <utility>

namespace burnish {

template <int Dim> void WorkpieceBody<Dim>::set_state(const BodyState<Dim>& state) {
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
  m_accepted = true;
}

template <int Dim> void WorkpieceBody<Dim>::accept() {
  add_step_error(*m_workpiece, m_step_error);
  std::vector<ElementEvent<Dim>> acting;
  if (!m_damage.empty()) acting = m_user.find(*m_workpiece);
  m_user.accept(*m_workpiece);
  m_workpiece->accept();
  m_damage.apply(acting, *m_workpiece);
  m_accepted = true;
}

template <int Dim> void WorkpieceBody<Dim>::revert() {
  m_user.revert();
  m_workpiece->revert();
  m_reverted = true;
}

template <int Dim> void WorkpieceBody<Dim>::start() {
  m_accepted = true;
  m_reverted = false;
}

template <int Dim> StateChange WorkpieceBody<Dim>::take_change() {
  if (!m_workpiece->user_defined()) return StateChange::NONE;
  if (std::exchange(m_accepted, false)) return StateChange::ACCEPTED;
  return std::exchange(m_reverted, false) ? StateChange::REVERTED : StateChange::NONE;
}

template <int Dim> double WorkpieceBody<Dim>::find_earliest(double tolerance, double noise) {
  m_pending = earliest(element_events(*m_workpiece, tolerance, noise), tolerance);
  return first_fraction(m_pending);
}

template <int Dim> void WorkpieceBody<Dim>::find_all() { m_pending = element_events(*m_workpiece, 0); }

template <int Dim> long WorkpieceBody<Dim>::accept_events() {
  burnish::accept_events(m_pending, *m_workpiece);
  const auto n = static_cast<long>(m_pending.size());
  m_pending.clear();
  return n;
}

template <int Dim> void WorkpieceBody<Dim>::keep_plastic(double noise) {
  burnish::keep_plastic(noise, *m_workpiece);
}

template <int Dim> double WorkpieceBody<Dim>::find_earliest_user(double overshoot, double least) {
  m_user.set_overshoot(overshoot);
  return m_user.earliest(*m_workpiece, least);
}

template <int Dim> std::vector<ElementEvent<Dim>> WorkpieceBody<Dim>::user_events() const {
  return m_user.find(*m_workpiece);
}

template <int Dim> double WorkpieceBody<Dim>::largest_yield_distance() const {
  double largest = -1;
  for (int p = 0; p < m_workpiece->discretization().num_points(); ++p)
    largest = std::max(largest, yield_distance(*m_workpiece, p));
  return largest;
}

template class WorkpieceBody<2>;
template class WorkpieceBody<3>;

} // namespace burnish

#include "stepping/run_body.hpp"
#include "base/error.hpp"

namespace burnish {

template <int Dim> void WorkpieceBody<Dim>::accept() {
  m_user.accept(*m_workpiece);
  m_workpiece->accept();
}

template <int Dim> void WorkpieceBody<Dim>::revert() {
  m_user.revert();
  m_workpiece->revert();
}

template <int Dim> double WorkpieceBody<Dim>::find_earliest(double tolerance, double noise) {
  m_pending = earliest(element_events(*m_workpiece, tolerance, noise), tolerance);
  return m_pending.empty() ? 2 : m_pending.front().fraction;
}

template <int Dim> void WorkpieceBody<Dim>::find_all() { m_pending = element_events(*m_workpiece, 0); }

template <int Dim> long WorkpieceBody<Dim>::accept_events() {
  switch_points(m_pending, *m_workpiece);
  const auto n = static_cast<long>(m_pending.size());
  m_pending.clear();
  return n;
}

template <int Dim> void WorkpieceBody<Dim>::keep_plastic(double noise) { hold_points(noise, *m_workpiece); }

template <int Dim> double WorkpieceBody<Dim>::find_earliest_user(double overshoot, double least) {
  return m_user.earliest(*m_workpiece, overshoot, least);
}

template <int Dim> std::vector<ElementEvent<Dim>> WorkpieceBody<Dim>::user_events() const {
  return m_user.find(*m_workpiece);
}

template <int Dim> double WorkpieceBody<Dim>::largest_yield_excess() const {
  double largest = -1;
  for (int p = 0; p < m_workpiece->discretization().num_points(); ++p)
    largest = std::max(largest, m_workpiece->yield_excess(p));
  return largest;
}

template class WorkpieceBody<2>;

} // namespace burnish

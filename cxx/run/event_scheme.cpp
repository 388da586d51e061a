#include "run/step_scheme.hpp"
#include <algorithm>

namespace burnish {
namespace {

// An event this close to the end of a piece, over the step, counts as at its end.
constexpr double LAST_PIECE = 1e-3;
constexpr int MAX_CUTS = 12; // shortenings of one piece; the last one is taken as it is
// Contact states may change this often at one instant; then a piece with the states inside the iteration finds the ones
// that agree.
constexpr int MAX_CHANGES = 3;
constexpr int MAX_POINT_CHANGES = 2; // the same of element events; then they are passed over at this instant

} // namespace

template <int Dim> void EventScheme<Dim>::start(double t, double dt) {
  m_t = this->m_reached = t;
  m_dt = dt;
  m_changes = m_point_changes = 0;
  next_piece();
}

// From the instant that has been reached to the end of the step.
template <int Dim> SchemeTask EventScheme<Dim>::next_piece() {
  m_cuts = 0;
  m_adapt = m_changes > MAX_CHANGES;
  double length = m_t + m_dt - this->m_reached;
  if (m_adapt) // in space many nodes are at their limits at once: pieces double what has been done of the step
    length = std::min(length, std::max(ESCAPE * m_dt, Dim == 3 ? this->m_reached - m_t : 0));
  this->m_solve = {this->m_reached, length, m_adapt ? Stepping::IMPLICIT : Stepping::EVENT};
  this->m_events.clear();
  return SchemeTask::SOLVE;
}

// The piece ends at its event; or, if that is at its beginning, the states change there and nothing moves.
template <int Dim> void EventScheme<Dim>::cut(double fraction, Eigen::VectorXd& u, Eigen::VectorXd& R) {
  const double shorter = fraction * this->m_solve.dt;
  const bool at_once = shorter <= AT_ONCE * m_dt;
  if (at_once) {
    this->m_contact.log_elements(this->m_body.pending());
    this->m_contact.accept_events(this->m_events);
    m_changes += !this->m_events.empty();
  }
  this->revert(u, R); // element events stay pending
  if (at_once) {
    m_point_changes += this->m_body.accept_events() > 0;
    next_piece();
    return;
  }
  ++m_cuts;
  this->m_solve.dt = shorter;
  this->m_events.clear();
}

template <int Dim> SchemeTask EventScheme<Dim>::take_piece(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  const ElementEvents elements = this->m_options.elements;
  if (elements == ElementEvents::CUT) {
    this->m_contact.log_elements(this->m_body.pending());
    keep_plastic(this->m_options.event_noise, this->m_body.workpiece());
  }
  if (elements == ElementEvents::LOG) this->log_all_elements();
  this->m_reached = this->m_solve.from + this->m_solve.dt;
  const std::vector<ContactEvent<Dim>> at_end = std::move(this->m_events);
  this->accept(u, R, at_end);
  this->m_body.accept_events();
  m_changes = m_point_changes = 0;
  this->m_counts.pileups += m_adapt;
  const bool more = this->m_reached < m_t + m_dt - SHORTEST_REST * m_dt;
  return more ? next_piece() : SchemeTask::ACCEPTED;
}

template <int Dim>
SchemeTask EventScheme<Dim>::solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R) {
  const SchemeOptions& o = this->m_options;
  if (!converged) {
    if (Dim == 3 && !m_adapt) { // no equilibrium with these states: one with states that agree
      this->revert(u, R);
      m_changes = MAX_CHANGES + 1;
      return next_piece();
    }
    const bool some = this->m_reached > m_t + SHORTEST_REST * m_dt;
    if (some) this->revert(u, R);
    return some ? SchemeTask::ACCEPTED : SchemeTask::REJECTED;
  }
  const double length = this->m_solve.dt;
  double fraction = 2;
  if (m_adapt)
    this->m_body.drop_events();
  else
    fraction = this->earliest(u, R, o.elements == ElementEvents::CUT && m_point_changes < MAX_POINT_CHANGES,
                              o.event_noise, 2 * AT_ONCE * m_dt / length);
  const bool ends = fraction > 1 || (1 - fraction) * length < LAST_PIECE * m_dt || m_cuts + 1 == MAX_CUTS;
  if (ends && fraction * length > AT_ONCE * m_dt) return take_piece(u, R);
  cut(fraction, u, R);
  return SchemeTask::SOLVE;
}

template class EventScheme<2>;
template class EventScheme<3>;

} // namespace burnish

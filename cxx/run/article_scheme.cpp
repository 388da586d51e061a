#include "run/step_scheme.hpp"
#include "workpiece/point_fields.hpp"
#include <algorithm>

namespace burnish {

template <int Dim> void ArticleScheme<Dim>::start(double t, double dt) {
  m_t = this->m_reached = t;
  m_dt = dt;
  m_pieces = m_retries = 0;
  next_piece();
}

// A blind piece locates no event: every state changes at its end.
template <int Dim> SchemeTask ArticleScheme<Dim>::next_piece() {
  const bool stuck = m_retries > this->m_options.max_retries;
  m_blind = stuck || m_pieces >= this->m_options.max_pieces;
  m_cut = false;
  double length = m_t + m_dt - this->m_reached;
  if (stuck) length = std::min(length, ESCAPE * m_dt);
  this->m_solve = {this->m_reached, length, Stepping::RATES};
  this->m_events.clear();
  return SchemeTask::SOLVE;
}

template <int Dim> SchemeTask ArticleScheme<Dim>::change_at_once(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  this->m_contact.log_elements(this->m_body.pending());
  this->m_contact.accept_events(this->m_events);
  this->revert(u, R);
  this->m_body.accept_events();
  ++m_retries;
  ++this->m_counts.at_once;
  return next_piece();
}

template <int Dim> SchemeTask ArticleScheme<Dim>::take_piece(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  const ElementEvents elements = this->m_options.elements;
  if (m_blind) this->m_events = this->m_contact.events(u, R, 1.);
  if (m_blind || elements != ElementEvents::CUT) {
    this->m_body.find_all();
    if (elements != ElementEvents::NONE) this->m_contact.log_elements(this->m_body.pending());
  }
  this->m_reached = this->m_solve.from + this->m_solve.dt;
  const std::vector<ContactEvent<Dim>> at_end = std::move(this->m_events);
  this->accept(u, R, at_end);
  this->m_body.accept_events();
  this->m_counts.excess = std::max(this->m_counts.excess, largest_yield_distance(this->m_body.workpiece()));
  this->m_counts.blind += m_blind;
  ++m_pieces;
  m_retries = 0;
  const bool more = this->m_reached < m_t + m_dt - SHORTEST_REST * m_dt;
  return more ? next_piece() : SchemeTask::ACCEPTED;
}

template <int Dim>
SchemeTask ArticleScheme<Dim>::solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R) {
  const SchemeOptions& o = this->m_options;
  if (!converged) {
    const bool some = this->m_reached > m_t + SHORTEST_REST * m_dt;
    this->revert(u, R);
    return some ? SchemeTask::ACCEPTED : SchemeTask::REJECTED;
  }
  if (m_cut) return take_piece(u, R);
  double fraction = 2;
  if (!m_blind)
    fraction =
        this->earliest(u, R, o.elements == ElementEvents::CUT, 0, 2 * AT_ONCE * m_dt / this->m_solve.dt);
  if (fraction * this->m_solve.dt <= AT_ONCE * m_dt) return change_at_once(u, R);
  if (fraction <= 1) this->m_contact.log_elements(this->m_body.pending());
  if (fraction >= 1) return take_piece(u, R);
  this->m_contact.condensed().cut(u, fraction); // everything is linear: the piece ends at the event
  this->m_solve.dt *= fraction;
  m_cut = true;
  return SchemeTask::FORCES;
}

template class ArticleScheme<2>;
template class ArticleScheme<3>;

} // namespace burnish

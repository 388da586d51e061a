#include "run/step_scheme.hpp"
#include <algorithm>

namespace burnish {

template <int Dim> void StepScheme<Dim>::revert(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  m_body.revert();
  m_contact.revert();
  u = m_contact.accepted().u;
  R = m_contact.accepted().R;
}

template <int Dim>
void StepScheme<Dim>::accept(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                             const std::vector<ContactEvent<Dim>>& events) {
  m_contact.log_elements(m_body.user_events());
  m_body.accept();
  m_contact.accept(u, R, events);
  ++m_counts.pieces;
}

template <int Dim> void StepScheme<Dim>::log_all_elements() {
  m_body.find_all();
  m_contact.log_elements(m_body.pending());
  m_body.drop_events();
}

template <int Dim>
double StepScheme<Dim>::earliest(const Eigen::VectorXd& u, const Eigen::VectorXd& R, bool elements,
                                 double noise, double least) {
  const double tolerance = m_options.event_tolerance;
  double inside = 2, user = 2;
  if (elements) {
    inside = m_body.find_earliest(tolerance, noise);
    user = m_body.find_earliest_user(tolerance, std::max(least, tolerance));
  }
  m_events = m_contact.events(u, R, tolerance, std::min({inside, user, 1.}));
  double first = user;
  for (const auto& event : m_events) first = std::min(first, event.fraction);
  if (!elements || inside > first + tolerance) m_body.drop_events();
  return std::min(first, inside);
}

// --- implicit

template <int Dim> void ImplicitScheme<Dim>::start(double t, double dt) {
  this->m_solve = {t, dt, Stepping::IMPLICIT};
  this->m_reached = t + dt;
}

template <int Dim>
SchemeTask ImplicitScheme<Dim>::solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R) {
  if (!converged) return SchemeTask::REJECTED;
  if (this->m_options.elements != ElementEvents::NONE) this->log_all_elements();
  this->accept(u, R, {});
  return SchemeTask::ACCEPTED;
}

template class StepScheme<2>;
template class StepScheme<3>;
template class ImplicitScheme<2>;
template class ImplicitScheme<3>;

} // namespace burnish

#include "run/jump_scheme.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr double START = 1e-4;    // viscosity at first: its springs over the mean diagonal of the tangent
constexpr double MOST = 100;      // and at most, over that
constexpr double STIFFER = 10;    // where a piece fails, ...
constexpr double SOFTER = 0.25;   // ... and where it does not
constexpr double AT_REST = 1e-6;  // viscous forces over the load below which the body has arrived
constexpr int MOST_PIECES = 200;  // of a march
constexpr double STANDING = 1e-3; // length of a piece at which the program stands still, over the step

} // namespace

template <int Dim> void JumpScheme<Dim>::start(double t, double dt) {
  m_contact_start = this->m_contact.state();
  m_body_start = this->m_body.state();
  NodeBlockMatrix<Dim> K = this->m_body.workpiece().pattern();
  this->m_body.workpiece().tangent(K, TangentKind::ELASTIC);
  m_stiffness = m_next = START * this->m_contact.loads().springs().stiffness_of(K);
  m_dissipated = 0;
  m_pieces = 0;
  m_refused = false;
  m_standing = STANDING * dt;
  this->m_reached = t + dt;
  piece(t);
}

// From there to the end of the step; a piece after the first one only begins and ends there.
template <int Dim> SchemeTask JumpScheme<Dim>::piece(double from) {
  this->m_solve = {from, this->m_reached - from, Stepping::IMPLICIT};
  this->m_contact.loads().viscosity = {m_next, this->m_contact.accepted().u};
  return SchemeTask::SOLVE;
}

template <int Dim>
SchemeTask JumpScheme<Dim>::solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R) {
  if (++m_pieces > MOST_PIECES) return give_up(u, R);
  if (converged) return m_next > 0 ? march(u, R) : arrive(u, R);
  m_next = m_next > 0 ? STIFFER * m_next : m_stiffness;
  if (m_next > MOST * m_stiffness) return give_up(u, R);
  this->revert(u, R);
  return piece(this->m_solve.from);
}

template <int Dim> SchemeTask JumpScheme<Dim>::give_up(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  this->m_contact.loads().viscosity = {};
  this->m_contact.revert();
  this->m_body.revert();
  this->m_contact.set_state(*m_contact_start);
  this->m_body.set_state(*m_body_start);
  u = this->m_contact.accepted().u;
  R = this->m_contact.accepted().R;
  return SchemeTask::REJECTED;
}

template <int Dim> SchemeTask JumpScheme<Dim>::march(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  const Eigen::VectorXd force = this->m_contact.loads().viscous_force(u);
  m_dissipated -= force.dot(u - this->m_contact.accepted().u);
  const double load = this->m_contact.iteration().balance().memory().scale;
  this->accept(u, R, {});
  const JumpMemory& jumps = this->m_contact.accepted().jumps;
  m_refused = jumps.dissipated + m_dissipated > this->m_options.jumps * std::abs(jumps.work);
  if (m_refused) return give_up(u, R);
  m_next = sum_of_norms<Dim>(force) > AT_REST * load ? SOFTER * m_next : 0;
  return piece(this->m_reached - m_standing);
}

template <int Dim> SchemeTask JumpScheme<Dim>::arrive(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  this->accept(u, R, {});
  this->m_contact.add_jump(m_contact_start->u, m_dissipated);
  return SchemeTask::ACCEPTED;
}

template class JumpScheme<2>;
template class JumpScheme<3>;

} // namespace burnish

#include "stepping/stepper.hpp"
#include "base/error.hpp"
#include "stepping/body_reason.hpp"
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace burnish {

template <int Dim>
Stepper<Dim>::Stepper(ContactRun<Dim>& contact, RunBody<Dim>& body, StepControl control,
                      StepperOptions options)
    : m_contact(contact), m_body(body), m_control(std::move(control)), m_options(options),
      m_implicit(contact, body, m_options.events, m_counts.scheme),
      m_event(contact, body, m_options.events, m_counts.scheme),
      m_article(contact, body, m_options.events, m_counts.scheme), m_scheme(&m_implicit) {}

template <int Dim> Task Stepper<Dim>::ask(Task task, Phase phase) {
  m_phase = phase;
  return task;
}

template <int Dim> Task Stepper<Dim>::next(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  if (m_stopped) return end(u, R);
  const bool done = !m_refused;
  switch (m_phase) {
  case Phase::STEP:
  case Phase::RECORD:
    return begin_step();
  case Phase::PROGRAM:
    return done ? begin_solve(u, R) : solved(false, u, R);
  case Phase::SOLVE:
    return done ? ask(Task::FORCES, Phase::FORCES) : solved(false, u, R);
  case Phase::FORCES:
    if (done) m_contact.add_hold(u, R);
    return done ? check(u, R) : solved(false, u, R);
  case Phase::TANGENT:
    return done ? correct(u, R) : solved(false, u, R);
  case Phase::ENDED:
    break;
  }
  return m_control.finished() ? Task::FINISHED : Task::STOPPED;
}

template <int Dim> void Stepper<Dim>::refuse(const std::string& reason) {
  m_refused = true;
  m_refusal = reason;
}

template <int Dim> void Stepper<Dim>::stop(const std::string& reason) {
  m_stopped = true;
  m_reason = reason;
}

template <int Dim> Task Stepper<Dim>::begin_step() {
  if (m_control.finished()) {
    warn_of_error();
    return ask(Task::FINISHED, Phase::ENDED);
  }
  const Workpiece<Dim>* workpiece = m_body.checked();
  if (workpiece && m_checks.options().on && !m_checks.begun()) m_checks.begin(accepted_step(*workpiece));
  const double narrow = m_options.width_steps * m_options.nodes_per_step * m_contact.body().spacing;
  m_control.stop_at(m_contact.hold().state().until);
  m_control.propose(std::max(m_contact.contact_width(), narrow), m_contact.contact_speed());
  if (m_options.scheme == Scheme::ARTICLE && m_body.has_damage())
    fail("Stepper",
         "scheme article with damage, expected implicit or event: pure rates never take off the force that a "
         "damaged point has lost");
  m_body.set_step_length(m_control.dt());
  m_tries = 0;
  m_disagreed = false;
  return try_step();
}

// Whether the present try is by events. States that never agree inside the iteration may agree one after another, and
// the other way round.
template <int Dim> bool Stepper<Dim>::by_events() const {
  if (m_options.scheme == Scheme::EVENT) return m_tries < m_options.max_tries;
  if (m_options.scheme != Scheme::IMPLICIT || m_options.fallback == 0 || m_options.condensed) return false;
  if (m_tries == 0) return m_counts.by_events > 0;
  return m_disagreed && m_tries >= m_options.fallback && (m_tries - m_options.fallback) % 2 == 0;
}

template <int Dim> Task Stepper<Dim>::try_step() {
  m_scheme = &m_implicit;
  if (by_events()) m_scheme = &m_event;
  if (m_options.scheme == Scheme::ARTICLE) m_scheme = &m_article;
  m_scheme->start(m_control.time(), m_control.dt());
  return ask(Task::PROGRAM, Phase::PROGRAM);
}

template <int Dim> Task Stepper<Dim>::begin_solve(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  const Solve& solve = m_scheme->solve();
  Corrector<Dim>& corrector = m_contact.corrector();
  if (solve.stepping == Stepping::IMPLICIT && corrector.options().steps_per_factor > 1 && m_control.is_last())
    corrector.drop_factor(); // so that no loss of stability is left unseen
  try {
    m_contact.begin(u, solve.from, solve.dt, solve.stepping);
  } catch (const std::exception&) {
    if (!falls_back()) throw;
    return rejected(u, R); // a piece has ended where there is no way on, e.g. off the body
  }
  m_iteration = 0;
  return solve.stepping == Stepping::RATES ? ask(Task::SOLVE, Phase::SOLVE)
                                           : ask(Task::FORCES, Phase::FORCES);
}

template <int Dim> Task Stepper<Dim>::check(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  if (m_scheme->solve().stepping == Stepping::RATES)
    return solved(m_contact.check_rates(u) == StepStatus::CONVERGED, u, R);
  ++m_iteration;
  switch (m_contact.check(u, R)) {
  case StepStatus::CONVERGED:
    return solved(true, u, R);
  case StepStatus::FAILED:
    return solved(false, u, R);
  case StepStatus::BACKTRACKED:
    return ask(Task::FORCES, Phase::FORCES);
  case StepStatus::REFACTORIZE:
    return m_options.condensed ? ask(Task::SOLVE, Phase::SOLVE) : ask(Task::TANGENT, Phase::TANGENT);
  case StepStatus::ITERATE:
    break;
  }
  return m_options.condensed ? ask(Task::SOLVE, Phase::SOLVE) : correct(u, R);
}

template <int Dim> Task Stepper<Dim>::correct(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  if (m_contact.correct(u, R) == StepStatus::FAILED) return solved(false, u, R);
  return ask(Task::FORCES, Phase::FORCES);
}

template <int Dim> Task Stepper<Dim>::solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R) {
  if (!converged && !falls_back()) { // a try by events has no reason of its own
    m_disagreed = m_disagreed || (m_refusal.empty() && m_contact.corrector().last_balance().inconsistent > 0);
    // of the contact: why the body was asked for too much
    const std::string cause = m_contact.reason(nearly_incompressible(m_body.checked()));
    const bool both = !cause.empty() && !m_refusal.empty();
    m_last_rejection = both ? cause + " (" + m_refusal + ")" : cause + m_refusal;
  }
  m_refused = false;
  m_refusal.clear();
  switch (m_scheme->solved(converged, u, R)) {
  case SchemeTask::SOLVE:
    return ask(Task::PROGRAM, Phase::PROGRAM);
  case SchemeTask::FORCES:
    return ask(Task::FORCES, Phase::FORCES);
  case SchemeTask::ACCEPTED:
    return accepted();
  case SchemeTask::REJECTED:
    break;
  }
  return rejected(u, R);
}

// How far the contact has rolled, and what the length of the step has cost.
template <int Dim> void Stepper<Dim>::measure_step() {
  constexpr double rolls = 1e-3; // spacings a step: less is no rolling
  const double nodes = m_contact.contact_speed() * m_contact.accepted().history.dt / m_contact.body().spacing;
  if (nodes > rolls) {
    ++m_counts.rolling;
    m_counts.travel += nodes;
  }
  m_control.steer(StepErrorState::STEP_ERROR_PER_ETA * m_body.step_error().last);
}

template <int Dim> void Stepper<Dim>::warn_of_error() {
  if (!(error() > m_options.warned_error)) return;
  std::ostringstream text;
  text << "the steps are long: about " << std::lround(100 * error()) << " % error of the plastic strain";
  if (m_counts.nodes_per_step() > 1)
    text << ", " << std::setprecision(2) << m_counts.nodes_per_step() << " nodes of rolling a step";
  text << "; take more steps, or state an accuracy";
  m_contact.warn("steps", text.str());
}

template <int Dim> Task Stepper<Dim>::accepted() {
  const double t = m_control.time(), dt = m_control.dt(), part = m_scheme->reached() - t;
  if (part < dt - m_options.events.rest * dt) m_control.cut(part / dt); // the rest of the step failed
  m_control.accepted();
  measure_step();
  m_counts.scheme.pileups += m_options.scheme == Scheme::EVENT && m_tries >= m_options.max_tries;
  ++m_counts.steps;
  if (m_options.scheme == Scheme::IMPLICIT) {
    m_counts.fallbacks += falls_back();
    m_counts.by_events = falls_back() && m_tries >= m_options.fallback ? m_options.fallback_steps
                                                                       : std::max(0, m_counts.by_events - 1);
  }
  m_body.set_step_length(0);
  look(m_control.time() - t);
  return ask(Task::RECORD, Phase::RECORD);
}

template <int Dim> AcceptedStep<Dim> Stepper<Dim>::accepted_step(const Workpiece<Dim>& workpiece) const {
  const ContactSetup<Dim>& setup = m_contact.setup();
  const ContactRunState<Dim>& state = m_contact.accepted();
  AcceptedStep<Dim> step{workpiece,     setup.mesh(), setup.surface(), setup.model(),          setup.body(),
                         state.contact, state.u,      state.R,         state.generalized_force};
  const Hold<Dim>& hold = m_contact.hold();
  if (hold.state().factor > 0) step.hold = hold.force(state.u, hold.state().factor);
  step.load = m_contact.corrector().load_scale();
  step.tolerance = m_contact.corrector().options().tolerance;
  step.t = m_control.time();
  step.last = m_control.finished();
  step.prescribed = &state.prescribed;
  step.window = state.corrector.window.size();
  return step;
}

// Self-checks of the accepted state; the run may end with it, once it is recorded.
template <int Dim> void Stepper<Dim>::look(double dt) {
  const Workpiece<Dim>* workpiece = m_body.checked();
  if (!workpiece || !m_checks.options().on || !m_checks.begun()) return;
  AcceptedStep<Dim> step = accepted_step(*workpiece);
  step.dt = dt;
  m_checks.look(step, m_contact.findings());
  m_scene_report.look(step);
  if (!m_checks.stop().empty()) stop(m_checks.stop());
}

template <int Dim> std::vector<Statement> Stepper<Dim>::report() const {
  const Workpiece<Dim>* workpiece = m_body.checked();
  if (!workpiece || !m_checks.begun()) return {};
  const AcceptedStep<Dim> step = accepted_step(*workpiece);
  StepAccuracy accuracy;
  accuracy.given = m_control.options().accuracy > 0;
  accuracy.asked = accuracy.given ? m_control.options().accuracy : m_options.warned_error;
  if (error() >= 0) accuracy.error = error();
  accuracy.longest = 0.5 * static_cast<double>(m_counts.steps) * m_control.options().dt_max <=
                     m_control.time() - m_control.start();
  return statements(ReportedRun<Dim>{step, m_scene_report.state(), m_checks.state(),
                                     m_contact.accepted().warnings.findings(), m_scene_report.options(),
                                     accuracy});
}

template <int Dim> Task Stepper<Dim>::rejected(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  ++m_counts.rejected;
  ++m_tries;
  m_rejected_dt = m_control.dt();
  m_body.revert();
  m_contact.revert();
  u = m_contact.accepted().u;
  R = m_contact.accepted().R;
  if (m_control.rejected()) return try_step();
  m_at_floor = true;
  stop(m_last_rejection);
  return end(u, R);
}

template <int Dim> Task Stepper<Dim>::end(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  m_body.set_step_length(0);
  warn_of_error();
  if (m_phase != Phase::ENDED && m_phase != Phase::STEP) {
    m_body.revert();
    m_contact.revert();
    u = m_contact.accepted().u;
    R = m_contact.accepted().R;
  }
  return ask(Task::STOPPED, Phase::ENDED);
}

template <int Dim> RunState<Dim> Stepper<Dim>::state() const {
  return {m_body.state(), m_contact.state(), m_control.state(),
          m_counts,       m_checks.state(),  m_scene_report.state()};
}

template <int Dim>
void Stepper<Dim>::set_state(const RunState<Dim>& state, Eigen::VectorXd& u, Eigen::VectorXd& R) {
  m_body.set_state(state.body);
  m_contact.set_state(state.contact);
  m_control.set_state(state.control);
  m_counts = state.counts;
  m_checks.set_state(state.checks);
  m_scene_report.set_state(state.scene);
  u = state.contact.u;
  R = state.contact.R;
  m_phase = Phase::STEP;
  m_stopped = m_refused = false;
}

template class Stepper<2>;
template class Stepper<3>;

} // namespace burnish

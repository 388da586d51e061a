#include "run/stepper.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "run/contact_motion.hpp"
#include "run/seen_step.hpp"
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace burnish {
namespace {

constexpr double WARNED_ERROR = 0.08; // estimated error of the steps that is reported as a warning
// An event step that failed so often is taken with the states inside the iteration.
constexpr int MAX_TRIES = 5;
// Marches to the next equilibrium: at most so many in a step, and the length of the first over the largest step.
constexpr int MARCHES = 3;
constexpr double MARCH = 5e-3;

} // namespace

template <int Dim>
Stepper<Dim>::Stepper(ContactRun<Dim>& contact, RunBody<Dim>& body, Diagnosis<Dim>& diagnosis,
                      StepControl control, StepperOptions options)
    : m_contact(contact), m_body(body), m_diagnosis(diagnosis), m_control(std::move(control)),
      m_options(options), m_implicit(contact, body, m_options.events, m_counts.scheme),
      m_jump(contact, body, m_options.events, m_counts.scheme),
      m_event(contact, body, m_options.events, m_counts.scheme),
      m_article(contact, body, m_options.events, m_counts.scheme), m_scheme(&m_implicit) {
  ElementEvents& elements = m_options.events.elements;
  if (elements == ElementEvents::DEFAULT)
    elements = m_options.scheme == Scheme::ARTICLE ? ElementEvents::CUT : ElementEvents::NONE;
  m_diagnosis.restart();
  m_body.start();
}

template <int Dim> Task Stepper<Dim>::ask(Task task, Phase phase) {
  m_phase = phase;
  return task;
}

template <int Dim> Task Stepper<Dim>::next(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  if (m_phase == Phase::ACCEPTED) return ask(Task::RECORD, Phase::RECORD);
  if (m_stopped) return end(u, R);
  const bool done = !m_refused;
  switch (m_phase) {
  case Phase::STEP:
  case Phase::RECORD:
    return begin_step();
  case Phase::PROGRAM:
    return done ? begin_solve(u) : solved(false, u, R);
  case Phase::SOLVE:
  case Phase::LAW:
    return done ? ask_forces() : solved(false, u, R);
  case Phase::FORCES:
    return done ? check(u, R) : solved(false, u, R);
  case Phase::TANGENT:
    return done ? correct(u, R) : solved(false, u, R);
  case Phase::ACCEPTED:
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
  m_diagnosis.begin(seen());
  m_control.stop_at(m_contact.loads().hold.state().until);
  propose();
  if (m_options.scheme == Scheme::ARTICLE && m_body.has_damage())
    fail("Stepper",
         "scheme article with damage, expected implicit or event: pure rates never take off the force that a "
         "damaged point has lost");
  m_body.workpiece().set_step_length(m_control.dt());
  m_tries = m_marches = 0;
  return try_step();
}

template <int Dim> void Stepper<Dim>::propose() {
  const double narrow = m_options.width_steps * m_options.nodes_per_step * m_contact.setup().body().spacing;
  m_control.propose(std::max(contact_width(m_contact), narrow), contact_speed(m_contact));
}

// The state of a law of the script cannot be taken back over several pieces.
template <int Dim> bool Stepper<Dim>::may_jump() const {
  if (m_scheme == &m_jump) return m_marches < MARCHES;
  return m_options.events.jumps > 0 && m_scheme == &m_implicit && !m_body.workpiece().user_defined() &&
         m_contact.iteration().failure().states_contradict();
}

template <int Dim> Task Stepper<Dim>::try_step() {
  m_scheme = &m_implicit;
  if (m_options.scheme == Scheme::EVENT && m_tries < MAX_TRIES) m_scheme = &m_event;
  if (m_options.scheme == Scheme::ARTICLE) m_scheme = &m_article;
  return begin_try();
}

template <int Dim> Task Stepper<Dim>::begin_try() {
  m_scheme->start(m_control.time(), m_control.dt());
  return ask(Task::PROGRAM, Phase::PROGRAM);
}

// A law of the caller's follows what became of the last step first.
template <int Dim> Task Stepper<Dim>::ask_forces() {
  const StateChange change = m_body.take_change();
  if (change == StateChange::ACCEPTED) return ask(Task::ACCEPT_LAW, Phase::LAW);
  if (change == StateChange::REVERTED) return ask(Task::REVERT_LAW, Phase::LAW);
  return ask(Task::FORCES, Phase::FORCES);
}

template <int Dim> Task Stepper<Dim>::begin_solve(Eigen::VectorXd& u) {
  const Solve& solve = m_scheme->solve();
  if (solve.stepping == Stepping::IMPLICIT && m_contact.iteration().options().steps_per_factor > 1 &&
      m_control.is_last())
    m_contact.corrector().drop_factor(); // so that no loss of stability is left unseen
  m_contact.begin(u, solve.from, solve.dt, solve.stepping);
  m_iteration = 0;
  return solve.stepping == Stepping::RATES ? ask(Task::SOLVE, Phase::SOLVE) : ask_forces();
}

template <int Dim> Task Stepper<Dim>::check(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  if (m_scheme->solve().stepping == Stepping::RATES)
    return solved(m_contact.check(u, R) == StepStatus::CONVERGED, u, R);
  ++m_iteration;
  const StepStatus status = m_contact.check(u, R);
  m_made = m_contact.iteration().number();
  switch (status) {
  case StepStatus::CONVERGED:
    return solved(true, u, R);
  case StepStatus::FAILED:
    return solved(false, u, R);
  case StepStatus::BACKTRACKED:
    return ask_forces();
  case StepStatus::REFACTORIZE:
    return ask(Task::TANGENT, Phase::TANGENT);
  case StepStatus::ITERATE:
    break;
  }
  return m_contact.condensed().again() ? ask(Task::TANGENT, Phase::TANGENT) : correct(u, R);
}

// A caller that has condensed, solved and expanded has made the iteration itself.
template <int Dim> Task Stepper<Dim>::correct(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  const bool made = m_contact.condensed().again() || m_contact.iteration().number() > m_made;
  if (!made && m_contact.correct(u, R) == StepStatus::FAILED) return solved(false, u, R);
  return ask_forces();
}

template <int Dim> Task Stepper<Dim>::solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R) {
  if (!converged && m_scheme != &m_jump) // why a march is given up is no reason for the step
    m_last_rejection = burnish::reason(m_contact, m_diagnosis, known_workpiece(), m_refusal);
  m_refused = false;
  m_refusal.clear();
  switch (m_scheme->solved(converged, u, R)) {
  case SchemeTask::SOLVE:
    return ask(Task::PROGRAM, Phase::PROGRAM);
  case SchemeTask::FORCES:
    return ask_forces();
  case SchemeTask::ACCEPTED:
    return accepted();
  case SchemeTask::REJECTED:
    if (m_scheme == &m_jump && m_jump.refused())
      m_refused_jump =
          sentence("; a jump to the next equilibrium dissipates more than jumps = ", m_options.events.jumps,
                   " of the tools' work");
    break;
  }
  return rejected(u, R);
}

// How far the contact has rolled, and what the length of the step has cost.
template <int Dim> void Stepper<Dim>::measure_step() {
  constexpr double rolls = 1e-3; // spacings a step: less is no rolling
  const double nodes =
      contact_speed(m_contact) * m_contact.accepted().history.dt / m_contact.setup().body().spacing;
  if (nodes > rolls) {
    ++m_counts.rolling;
    m_counts.travel += nodes;
  }
  m_control.steer(StepErrorState::STEP_ERROR_PER_ETA * m_body.step_error().last);
}

template <int Dim> void Stepper<Dim>::warn_of_error() {
  if (!(error() > WARNED_ERROR)) return;
  Finding* finding =
      m_diagnosis.findings().report("contact", "steps", Severity::WARNING, 0, m_control.time());
  if (!finding) return;
  finding->text =
      sentence("the steps are long: about ", std::lround(100 * error()), " % error of the plastic strain");
  if (m_counts.nodes_per_step() > 1)
    finding->text +=
        sentence(", ", std::setprecision(2), m_counts.nodes_per_step(), " nodes of rolling a step");
  finding->text += "; take more steps, or state an accuracy";
}

template <int Dim> Task Stepper<Dim>::accepted() {
  const double t = m_control.time(), dt = m_control.dt(), part = m_scheme->reached() - t;
  if (part < dt - SHORTEST_REST * dt) m_control.cut(part / dt); // the rest of the step failed
  m_refused_jump.clear();
  m_control.accepted();
  measure_step();
  m_counts.scheme.pileups += m_options.scheme == Scheme::EVENT && m_tries >= MAX_TRIES;
  ++m_counts.steps;
  m_body.workpiece().set_step_length(0);
  look(m_control.time() - t);
  return m_body.take_change() == StateChange::ACCEPTED ? ask(Task::ACCEPT_LAW, Phase::ACCEPTED)
                                                       : ask(Task::RECORD, Phase::RECORD);
}

template <int Dim> AcceptedStep<Dim> Stepper<Dim>::seen() const {
  AcceptedStep<Dim> step = accepted_step(m_contact, known_workpiece());
  step.t = m_control.time();
  step.last = m_control.finished();
  return step;
}

// The diagnosis of the accepted state; the run may end with it, once it is recorded.
template <int Dim> void Stepper<Dim>::look(double dt) {
  AcceptedStep<Dim> step = seen();
  step.dt = dt;
  const std::string why = m_diagnosis.look(std::move(step));
  if (why.empty()) return;
  m_halted = true;
  stop(why);
}

template <int Dim> std::vector<Statement> Stepper<Dim>::report() const {
  StepAccuracy accuracy;
  accuracy.given = m_control.options().accuracy > 0;
  accuracy.asked = accuracy.given ? m_control.options().accuracy : WARNED_ERROR;
  if (error() >= 0) accuracy.error = error();
  accuracy.longest = 0.5 * static_cast<double>(m_counts.steps) * m_control.options().dt_max <=
                     m_control.time() - m_control.start();
  return m_diagnosis.report(seen(), accuracy);
}

template <int Dim> Task Stepper<Dim>::rejected(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  ++m_counts.rejected;
  ++m_tries;
  const bool jumps = may_jump(), marches = m_scheme == &m_jump;
  if (!marches) m_rejected_dt = m_control.dt();
  m_body.revert();
  m_contact.revert();
  u = m_contact.accepted().u;
  R = m_contact.accepted().R;
  const bool shorter = m_control.rejected() && !marches;
  if (jumps && !shorter) {
    if (!marches) m_control.retry(MARCH * m_control.options().dt_max);
    ++m_marches;
    m_scheme = &m_jump;
    return begin_try();
  }
  if (shorter) return try_step();
  if (m_scheme == &m_event) { // not without one try with the states inside the iteration
    m_tries = MAX_TRIES;
    propose();
    return try_step();
  }
  m_at_floor = true;
  stop(m_last_rejection + m_refused_jump);
  return end(u, R);
}

template <int Dim> Task Stepper<Dim>::end(Eigen::VectorXd& u, Eigen::VectorXd& R) {
  m_body.workpiece().set_step_length(0);
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
  std::vector<std::vector<Prescription::Entry>> drives;
  for (const auto& tool : m_contact.setup().tools()) drives.push_back(tool->prescription().entries());
  return {m_body.state(), m_contact.state(), m_control.state(), m_counts,     m_diagnosis,
          drives,         m_options.scheme,  m_last_rejection,  m_rejected_dt};
}

template <int Dim>
void Stepper<Dim>::set_state(const RunState<Dim>& state, Eigen::VectorXd& u, Eigen::VectorXd& R) {
  const auto& tools = m_contact.setup().tools();
  require(state.drives.size() == tools.size(), "Stepper", "number of tools in the state", state.drives.size(),
          std::to_string(tools.size()).c_str());
  for (std::size_t t = 0; t < tools.size(); ++t) tools[t]->prescription().set_entries(state.drives[t]);
  m_body.set_state(state.body);
  m_contact.set_state(state.contact);
  const ContactRunState<Dim>& at = state.contact;
  if (at.history.dt > 0) m_contact.iteration().balance().look(at.contact, at.prescribed, at.u, at.R);
  m_control.set_state(state.control);
  m_counts = state.counts;
  m_diagnosis = state.diagnosis;
  m_options.scheme = state.scheme;
  m_last_rejection = state.last_rejection;
  m_rejected_dt = state.rejected_dt;
  u = state.contact.u;
  R = state.contact.R;
  m_phase = Phase::STEP;
  m_stopped = m_refused = false;
}

template class Stepper<2>;
template class Stepper<3>;

} // namespace burnish

#include "run/contact_run.hpp"
#include "base/error.hpp"
#include "contact/coupling.hpp"
#include "contact/driving_force.hpp"
#include "contact/tributary_area.hpp"
#include "diagnosis/before/floating_check.hpp"
#include "diagnosis/before/program_checks.hpp"
#include "diagnosis/before/unresisted.hpp"
#include "diagnosis/step/leaps.hpp"
#include "formula/formula.hpp"
#include "run/approach.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr int EVENT_STEPS_PER_FACTOR = 2; // event steps that one factor serves

template <int Dim> bool slides_with_friction(const TangentialLaw<Dim>& law) {
  return !law.frictionless() && !law.friction().sticks_always();
}

Failure without_value(const FormulaDomainError& error) {
  Failure failure(Cause::FORMULA);
  failure.text = error.what();
  return failure;
}

} // namespace

template <int Dim>
ContactRun<Dim>::ContactRun(std::shared_ptr<ContactSetup<Dim>> setup, IterationOptions options)
    : m_setup((setup->close(), std::move(setup))), m_iteration(m_setup->model(), m_setup->body(), options),
      m_corrector(m_iteration), m_predictor(m_setup->mesh(), m_setup->model(), m_setup->body()),
      m_loads(m_setup->mesh(), m_setup->body()),
      m_condensed(m_iteration, m_loads, m_step, m_accepted.contact) {
  m_accepted.u = m_accepted.R = Eigen::VectorXd::Zero(m_setup->mesh().num_dofs());
  m_accepted.contact.nodes.resize(m_setup->candidates().size());
  m_accepted.generalized_force = Eigen::VectorXd::Zero(m_setup->model().num_coordinates());
  take_places();
}

// Where the script placed the tools; coordinates that follow are placed by what they follow.
template <int Dim> void ContactRun<Dim>::take_places() {
  m_accepted.contact.q = m_setup->placed();
  m_accepted.references.clear();
  for (const auto& tool : m_setup->model().tools)
    m_accepted.references.push_back(tool->coordinates().reference());
  follow(m_setup->model(), m_accepted.contact.q);
  if (!m_setup->model().couplings.empty()) update_tools();
}

template <int Dim> ContactRunState<Dim> ContactRun<Dim>::state() const {
  ContactRunState<Dim> state = m_accepted;
  state.load = m_iteration.balance().memory();
  state.factor = m_corrector.memory();
  state.counts = m_iteration.counts();
  state.hold = m_loads.hold.state();
  return state;
}

template <int Dim> void ContactRun<Dim>::set_state(const ContactRunState<Dim>& state) {
  require(state.contact.nodes.size() == m_setup->candidates().size(), "contact",
          "number of nodes in the state", state.contact.nodes.size(), "that of the candidates");
  m_accepted = state;
  m_iteration.balance().memory() = state.load;
  m_iteration.counts() = state.counts;
  m_iteration.state() = state.contact;
  m_corrector.restore(state.factor);
  m_loads.supports.restore(state.support_displacement, state.support_origin);
  m_loads.external.restore(state.external, state.external_lost);
  m_loads.hold.set_state(state.hold);
  m_step.left_out.clear();
  m_step.log.events.clear();
  m_step.stage = StepUnderWay<Dim>::Stage::NONE;
  update_tools();
}

template <int Dim> void ContactRun<Dim>::update_tools() {
  for (std::size_t t = 0; t < m_setup->tools().size(); ++t) {
    m_setup->model().tools[t]->coordinates().refer_to(m_accepted.references[t]);
    m_setup->tools()[t]->q() = m_setup->model().tool_q(m_accepted.contact.q, static_cast<int>(t));
    m_setup->tools()[t]->generalized_force() =
        m_setup->model().tool_q(m_accepted.generalized_force, static_cast<int>(t));
  }
}

// Every node's tributary area, for laws of pressure and traction.
template <int Dim>
void ContactRun<Dim>::take_areas(ContactState<Dim>& state, const Eigen::VectorXd& u) const {
  const Eigen::VectorXd area = tributary_areas(m_setup->model(), m_setup->body(), m_setup->surface(), u);
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    state.nodes[i].tributary_area = area[static_cast<Eigen::Index>(i)];
}

template <int Dim>
double ContactRun<Dim>::approach(int tool, const std::string& coordinate, const Eigen::VectorXd& u) {
  require(tool >= 0 && tool < static_cast<int>(m_setup->tools().size()), "contact.approach", "tool", tool,
          "a tool that was added");
  require(u.size() == m_accepted.u.size(), "contact.approach", "size of u", u.size(), "number of dofs");
  DrivenTool<Dim>& placed = *m_setup->tools()[tool];
  const int k = placed.index(coordinate);
  ContactState<Dim> state = m_accepted.contact;
  state.q.segment(m_setup->model().first[tool], placed.q().size()) = placed.q();
  follow(m_setup->model(), state.q);
  m_accepted.contact = approached(*m_setup, std::move(state), u, tool, k);
  m_accepted.u = u;
  if (!m_setup->model().couplings.empty()) {
    follow(m_setup->model(), m_accepted.contact.q);
    update_tools();
  }
  return placed.q()[k] = m_accepted.contact.q[m_setup->model().first[tool] + k];
}

// Values at the start of the step in the kinds (motion or force) of its end: for pure rates. A coordinate
// that was under motion has received a force.
template <int Dim> PrescribedValues ContactRun<Dim>::start_values() const {
  PrescribedValues start{m_step.prescribed.is_motion, m_accepted.contact.q};
  const PrescribedValues& before = m_accepted.prescribed;
  const bool known = before.value.size() == m_step.prescribed.value.size();
  const Eigen::VectorXd last =
      known ? driving_force(m_setup->model(), before, m_accepted.contact.q).value : before.value;
  for (Eigen::Index q = 0; q < start.value.size(); ++q) {
    if (start.is_motion[q]) continue;
    start.value[q] = known && !before.is_motion[q] ? last[q] : m_accepted.generalized_force[q];
  }
  return start;
}

// A coordinate under force goes on as in the last step, or stays where it is if its formulas end there.
template <int Dim> Prediction<Dim> ContactRun<Dim>::predicted(const Eigen::VectorXd& u) const {
  if (m_step.stepping == Stepping::RATES) return m_predictor.rest(m_accepted.contact, u);
  const bool implicit = m_step.stepping == Stepping::IMPLICIT;
  const CarriedStates states{implicit, m_iteration.options().tied && (Dim == 2 || implicit)};
  const auto predict = [&](const StepHistory<Dim>& history) {
    return m_predictor.predict(m_step.prescribed, m_accepted.contact, u, history, m_step.dt, states);
  };
  try {
    return predict(m_accepted.history);
  } catch (const FormulaDomainError&) {
    StepHistory<Dim> still = m_accepted.history;
    still.dq.setZero();
    return predict(still);
  }
}

// Motion of the supports, external forces and hold; pure rates know none of them.
template <int Dim> void ContactRun<Dim>::begin_body(double t, Stepping stepping, const Eigen::VectorXd& u) {
  m_loads.hold.begin(t, u);
  m_loads.external.begin();
  if (stepping != Stepping::RATES) return;
  const auto& laws = m_setup->model().laws;
  if (Dim == 3 && std::any_of(laws.begin(), laws.end(), slides_with_friction<Dim>))
    fail("contact.begin", "pure rates in space have no equation for the direction of slip, which turns; take "
                          "the scheme implicit or event, or no friction");
  if (m_iteration.options().friction_tangent != FrictionTangent::CONSISTENT)
    fail("contact.begin", "pure rates are solved once and need frictiontangent=\"consistent\"");
  if (m_loads.supports.move(u))
    fail("contact.begin", "pure rates know no motion of supports; take the scheme implicit or event");
  if (m_loads.external.act())
    fail("contact.begin", "pure rates know no external forces; take the scheme implicit or event");
  if (m_loads.hold.acts(t))
    fail("contact.begin", "pure rates know no hold; take the scheme implicit or event");
}

// What the program prescribes for the end of the step, and whether that can be.
template <int Dim> void ContactRun<Dim>::begin_program(const Eigen::VectorXd& u, double end) {
  const bool first = m_accepted.history.dt == 0;
  ContactState<Dim>& state = m_accepted.contact;
  PrescribedValues& prescribed = m_step.prescribed;
  if (first) // the script's places count, after another tool's approach too
    take_places();
  else
    check_not_placed(*m_setup, state);
  prescribed = prescribed_values(*m_setup, end);
  prescribed.held = held_by_drive(driving_force(m_setup->model(), prescribed, state.q), prescribed);
  if (first) {
    check_not_inside(*m_setup, m_predictor.locator(), state, u);
    touch_in_place(*m_setup, u, state);
  }
  m_step.left_out = leave_out_unresisted(*m_setup, state, u, prescribed);
  for (const std::string& idle : check_support(*m_setup, state, prescribed, first))
    m_step.left_out.push_back(idle);
  check_independent(*m_setup, state, prescribed);
  if (!first) return;
  take_areas(state, u);
  m_accepted.u = u;
}

template <int Dim> void ContactRun<Dim>::begin(Eigen::VectorXd& u, double t, double dt, Stepping stepping) {
  require(std::isfinite(dt) && dt > 0, "contact.begin", "dt", dt, "> 0");
  require(u.size() == m_accepted.u.size(), "contact.begin", "size of u", u.size(), "number of dofs");
  if (!u.allFinite()) fail("contact.begin", "the displacement contains NaN or Inf");
  m_step.stage = StepUnderWay<Dim>::Stage::NONE;
  begin_program(u, t + dt);
  begin_body(t, stepping, u);
  if (!m_loads.hold.acts(t + dt)) check_not_floating(*m_setup, m_accepted.contact, m_step.prescribed, u);
  m_step.t = t;
  m_step.dt = dt;
  m_step.stepping = stepping;
  m_step.u_start = u;
  m_step.log.events.clear();
  m_step.prescribed_start = start_values();
  m_accepted.largest_dt = std::max(m_accepted.largest_dt, dt);
  auto prediction = predicted(u);
  u = prediction.u;
  m_step.ways = std::move(prediction.ways);
  m_loads.supports.apply(u);
  const int served =
      stepping == Stepping::EVENT ? EVENT_STEPS_PER_FACTOR : m_iteration.options().steps_per_factor;
  m_iteration.begin(m_step.prescribed, prediction.state, std::move(prediction.entry),
                    stepping == Stepping::IMPLICIT);
  const bool serves_on = stepping == Stepping::EVENT || served > 1;
  if (serves_on) m_corrector.keep_matrices();
  m_corrector.begin(m_corrector.factor_age() < served && serves_on);
  m_condensed.begin();
  // a step of pure rates is solved once and not checked
  m_step.stage =
      stepping == Stepping::RATES ? StepUnderWay<Dim>::Stage::CHECKED : StepUnderWay<Dim>::Stage::BEGUN;
}

// An equilibrium that the step has no way to: beyond a body that a tool has passed, or beyond a limit load.
template <int Dim> Failure ContactRun<Dim>::leaps(const Eigen::VectorXd& u) const {
  const SteppedPath<Dim> path{&m_accepted.contact, &m_iteration.state(), &m_step.u_start, &u};
  const Failure passage = tool_passage(*m_setup, path);
  if (passage || m_step.stepping == Stepping::RATES || m_loads.viscosity.stiffness > 0)
    return passage; // a march may leap
  const auto& last = m_accepted.history;
  const StepRates rates{m_step.dt, last.dt, last.dq, last.du, m_iteration.first_increment()};
  const Failure jump = body_jump(*m_setup, path, rates, m_loads.hold.acts(m_step.end()));
  return jump ? jump : sudden_jump(*m_setup, path, m_step.prescribed, rates);
}

template <int Dim> StepStatus ContactRun<Dim>::checked(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  if (m_condensed.again()) return StepStatus::ITERATE; // states have changed, nothing has moved
  if (m_condensed.gave_up()) return StepStatus::FAILED;
  StepStatus status = StepStatus::CONVERGED;
  if (m_step.stepping != Stepping::RATES) status = m_iteration.check(u, m_loads.residual(u, m_step.end(), R));
  if (status == StepStatus::BACKTRACKED) m_corrector.forget_mixing();
  if (status == StepStatus::ITERATE && !m_corrector.serves(u)) return StepStatus::REFACTORIZE;
  if (status != StepStatus::CONVERGED) return status;
  const Failure leap = leaps(u);
  return leap ? m_iteration.give_up(leap) : status;
}

// An iterate where a formula has no value fails the step: a shorter one may stay clear of it.
template <int Dim> StepStatus ContactRun<Dim>::check(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  m_step.require_begun("contact.check");
  m_step.stage = StepUnderWay<Dim>::Stage::CHECKED;
  double held = m_loads.hold.carried(u, m_step.end());
  if (m_loads.supports.displacement().size() >
      0) // with nothing in the body's way only rounding is left to balance
    held += m_iteration.balance().memory().rounding / m_iteration.options().tolerance;
  m_iteration.balance().set_held(held);
  try {
    return checked(u, R);
  } catch (const FormulaDomainError& error) {
    return m_iteration.give_up(without_value(error));
  }
}

template <int Dim> StepStatus ContactRun<Dim>::correct(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  m_step.require_checked("contact.correct");
  if (m_iteration.policy().condensed() && !m_corrector.has_factor())
    return StepStatus::ITERATE; // take_tangent has made it
  try {
    return m_corrector.correct(u, m_loads.residual(u, m_step.end(), R));
  } catch (const FormulaDomainError& error) {
    return m_iteration.give_up(without_value(error));
  }
}

template <int Dim> FactorStatus ContactRun<Dim>::factorize(NodeBlockMatrix<Dim> K, const Eigen::VectorXd& u) {
  m_step.require_begun("contact.factorize");
  const bool fits = K.size() == m_setup->body().X.size(); // else refused by who asks
  if (fits) m_loads.add_springs(m_step.end(), K);
  return m_corrector.factorize(std::move(K), u);
}

template class ContactRun<2>;
template class ContactRun<3>;

} // namespace burnish

#include "stepping/contact_run.hpp"
#include "base/error.hpp"
#include "base/formula.hpp"
#include "contact/coupling.hpp"
#include "contact/driving_force.hpp"
#include "contact/slip_motion.hpp"
#include "contact/tributary_area.hpp"
#include "stepping/approach.hpp"
#include "stepping/contact_window.hpp"
#include "stepping/floating_check.hpp"
#include "stepping/program_checks.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

template <int Dim>
ContactRun<Dim>::ContactRun(std::shared_ptr<ContactSetup<Dim>> setup)
    : m_setup((setup->close(), std::move(setup))), m_corrector(model(), body(), m_setup->options()),
      m_predictor(m_setup->mesh(), model(), body()), m_condensation(model(), body()), m_supports(body()),
      m_hold(m_setup->mesh(), body()) {
  m_accepted.u = m_accepted.R = Eigen::VectorXd::Zero(m_setup->mesh().num_dofs());
  m_accepted.contact.nodes.resize(m_setup->candidates().size());
  m_accepted.generalized_force = Eigen::VectorXd::Zero(model().num_coordinates());
  take_places();
  m_accepted.warnings.check_curvature(*m_setup);
}

// Where the script placed the tools; coordinates that follow are placed by what they follow.
template <int Dim> void ContactRun<Dim>::take_places() {
  m_accepted.contact.q = m_setup->placed();
  follow(model(), m_accepted.contact.q);
  if (!model().couplings.empty()) update_tools();
}

template <int Dim> ContactRunState<Dim> ContactRun<Dim>::state() const {
  ContactRunState<Dim> state = m_accepted;
  state.corrector = m_corrector.memory();
  state.counts = m_corrector.counts();
  state.largest_dt = m_largest_dt;
  state.hold = m_hold.state();
  return state;
}

template <int Dim> void ContactRun<Dim>::set_state(const ContactRunState<Dim>& state) {
  require(state.contact.nodes.size() == m_setup->candidates().size(), "contact",
          "number of nodes in the state", state.contact.nodes.size(), "that of the candidates");
  m_accepted = state;
  m_corrector.restore(state.corrector);
  m_corrector.set_counts(state.counts);
  m_corrector.state() = state.contact;
  m_largest_dt = state.largest_dt;
  m_supports.restore(state.support_displacement);
  m_hold.set_state(state.hold);
  m_left_out.clear();
  m_log.events.clear();
  m_stage = Stage::NONE;
  update_tools();
}

template <int Dim> std::vector<std::string> ContactRun<Dim>::left_out() const {
  std::vector<std::string> names = m_accepted.left_out;
  for (const std::string& name : m_left_out)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

template <int Dim> void ContactRun<Dim>::update_tools() {
  for (std::size_t t = 0; t < m_setup->tools().size(); ++t) {
    m_setup->tools()[t]->q() = model().tool_q(m_accepted.contact.q, static_cast<int>(t));
    m_setup->tools()[t]->generalized_force() =
        model().tool_q(m_accepted.generalized_force, static_cast<int>(t));
  }
}

// Every node's tributary area, for laws of pressure and traction.
template <int Dim>
void ContactRun<Dim>::take_areas(ContactState<Dim>& state, const Eigen::VectorXd& u) const {
  const Eigen::VectorXd area = tributary_areas(model(), body(), m_setup->surface(), u);
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
  state.q.segment(model().first[tool], placed.q().size()) = placed.q();
  follow(model(), state.q);
  m_accepted.contact = approached(*m_setup, std::move(state), u, tool, k);
  m_accepted.u = u;
  if (!model().couplings.empty()) {
    follow(model(), m_accepted.contact.q);
    update_tools();
  }
  return placed.q()[k] = m_accepted.contact.q[model().first[tool] + k];
}

// Values at the start of the step in the kinds (motion or force) of its end: for pure rates. A coordinate
// that was under motion has received a force.
template <int Dim> PrescribedValues ContactRun<Dim>::start_values() const {
  PrescribedValues start{m_prescribed.is_motion, m_accepted.contact.q};
  const PrescribedValues& before = m_accepted.prescribed;
  const bool known = before.value.size() == m_prescribed.value.size();
  const Eigen::VectorXd last =
      known ? driving_force(model(), before, m_accepted.contact.q).value : before.value;
  for (Eigen::Index q = 0; q < start.value.size(); ++q) {
    if (start.is_motion[q]) continue;
    start.value[q] = known && !before.is_motion[q] ? last[q] : m_accepted.generalized_force[q];
  }
  return start;
}

// A coordinate under force goes on as in the last step, or stays where it is if its formulas end there.
template <int Dim> Prediction<Dim> ContactRun<Dim>::predicted(const Eigen::VectorXd& u) const {
  if (m_stepping == Stepping::RATES) return m_predictor.rest(m_accepted.contact, u);
  const bool carry = m_stepping == Stepping::IMPLICIT, tied = m_corrector.options().tied;
  try {
    return m_predictor.predict(m_prescribed, m_accepted.contact, u, m_accepted.history, m_dt, carry, tied);
  } catch (const FormulaDomainError&) {
    StepHistory<Dim> still = m_accepted.history;
    still.dq.setZero();
    return m_predictor.predict(m_prescribed, m_accepted.contact, u, still, m_dt, carry, tied);
  }
}

// Motion of the supports and hold; pure rates know neither.
template <int Dim> void ContactRun<Dim>::begin_body(double t, Stepping stepping, const Eigen::VectorXd& u) {
  m_hold.begin(t, u);
  if (stepping != Stepping::RATES) return;
  if (m_corrector.options().friction_tangent != FrictionTangent::CONSISTENT)
    fail("contact.begin", "pure rates are solved once and need frictiontangent=\"consistent\"");
  if (m_supports.move(u))
    fail("contact.begin", "pure rates know no motion of supports; take the scheme implicit or event");
  if (m_hold.acts(t)) fail("contact.begin", "pure rates know no hold; take the scheme implicit or event");
}

template <int Dim> void ContactRun<Dim>::begin(Eigen::VectorXd& u, double t, double dt, Stepping stepping) {
  require(std::isfinite(dt) && dt > 0, "contact.begin", "dt", dt, "> 0");
  require(u.size() == m_accepted.u.size(), "contact.begin", "size of u", u.size(), "number of dofs");
  if (!u.allFinite()) fail("contact.begin", "the displacement contains NaN or Inf");
  m_stage = Stage::NONE;
  const bool first = m_accepted.history.dt == 0;
  if (first) // the script's places count, after another tool's approach too
    take_places();
  else
    check_not_placed(*m_setup, m_accepted.contact);
  m_prescribed = prescribed_values(*m_setup, t + dt);
  m_prescribed.held = held_by_drive(driving_force(model(), m_prescribed, m_accepted.contact.q), m_prescribed);
  if (first) check_not_inside(*m_setup, m_predictor.locator(), m_accepted.contact, u);
  m_left_out = leave_out_unresisted(*m_setup, m_accepted.contact, m_prescribed);
  check_support(*m_setup, m_accepted.contact, m_prescribed);
  check_independent(*m_setup, m_accepted.contact, m_prescribed);
  if (first) {
    take_areas(m_accepted.contact, u);
    m_accepted.u = u;
  }
  begin_body(t, stepping, u);
  if (!m_hold.acts(t + dt)) check_not_floating(*m_setup, m_accepted.contact, m_prescribed, u);
  m_t = t;
  m_dt = dt;
  m_largest_dt = std::max(m_largest_dt, dt);
  m_stepping = stepping;
  m_u_start = u;
  m_log.events.clear();
  m_prescribed_start = start_values();
  auto prediction = predicted(u);
  u = prediction.u;
  m_supports.apply(u);
  const StepOptions& options = m_corrector.options();
  const int served = stepping == Stepping::EVENT ? options.event_steps_per_factor : options.steps_per_factor;
  const bool keep = m_corrector.factor_age() < served && (stepping == Stepping::EVENT || served > 1);
  m_corrector.begin(m_prescribed, prediction.state, std::move(prediction.entry),
                    stepping == Stepping::IMPLICIT, keep);
  // a step of pure rates is solved once and not checked
  m_stage = stepping == Stepping::RATES ? Stage::CHECKED : Stage::BEGUN;
}

template <int Dim> void ContactRun<Dim>::require_begun(const char* where) const {
  if (m_stage == Stage::NONE) fail(where, "no step is under way, call begin first");
}
template <int Dim> void ContactRun<Dim>::require_checked(const char* where) const {
  require_begun(where);
  if (m_stage != Stage::CHECKED) fail(where, "this step has not been checked, call check first");
}

// An iterate where a formula has no value fails the step: a shorter one may stay clear of it.
template <int Dim> StepStatus ContactRun<Dim>::check(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  require_begun("contact.check");
  m_stage = Stage::CHECKED;
  double held = m_hold.carried(u, t_end());
  if (m_supports.displacement().size() > 0) // with nothing in the body's way only rounding is left to balance
    held += m_corrector.memory().rounding / m_corrector.options().tolerance;
  m_corrector.set_held(held);
  try {
    const StepStatus status = m_corrector.check(u, R);
    const std::string leap = status == StepStatus::CONVERGED ? leaps(u) : "";
    return leap.empty() ? status : m_corrector.give_up(leap);
  } catch (const FormulaDomainError& error) {
    return m_corrector.give_up(error.what());
  }
}

template <int Dim> StepStatus ContactRun<Dim>::correct(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  require_checked("contact.correct");
  try {
    return m_corrector.correct(u, R);
  } catch (const FormulaDomainError& error) {
    return m_corrector.give_up(error.what());
  }
}

template <int Dim> const NodeBlockMatrix<Dim>& ContactRun<Dim>::with_hold(const NodeBlockMatrix<Dim>& K) {
  if (!m_hold.acts(t_end()) || K.size() != body().X.size()) return K;
  m_held = K;
  m_hold.add_stiffness(t_end(), m_held);
  return m_held;
}

template <int Dim>
FactorStatus ContactRun<Dim>::factorize(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u) {
  require_begun("contact.factorize");
  return m_corrector.factorize(with_hold(K), u);
}

template <int Dim>
const CondensedSystem& ContactRun<Dim>::condense(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u,
                                                 const Eigen::VectorXd& R, GeometricTerms terms,
                                                 RightHandSide right, bool half) {
  require_begun("contact.condense");
  require(u.size() == m_accepted.u.size() && R.size() == m_accepted.u.size(), "contact.condense",
          "size of the arrays", R.size(), "number of dofs");
  if (!R.allFinite()) fail("contact.condense", "the force array contains NaN or Inf");
  m_corrector.count_condensation();
  m_corrector.prepare_condensed();
  return m_condensation.condense(with_hold(K), m_corrector.state(), {&m_prescribed, &m_prescribed_start}, u,
                                 R, terms, right, half, m_corrector.options().friction_tangent);
}

template <int Dim> double ContactRun<Dim>::expand(const Eigen::VectorXd& z, Eigen::VectorXd& u) {
  require_begun("contact.expand");
  require(u.size() == m_accepted.u.size(), "contact.expand", "size of u", u.size(), "number of dofs");
  const auto increment = m_condensation.expand(z);
  if (m_stepping == Stepping::RATES) {
    u += increment.du;
    move_by(model(), increment, m_corrector.state());
  } else {
    m_corrector.advance(increment, u);
  }
  return increment.du.cwiseAbs().maxCoeff();
}

template <int Dim> void ContactRun<Dim>::cut(Eigen::VectorXd& u, double fraction) {
  const char* where = "contact.cut";
  require_begun(where);
  if (m_stepping != Stepping::RATES)
    fail(where, "only a step of pure rates is linear: begin it with rates=true");
  require(fraction > 0 && fraction <= 1, where, "fraction", fraction, "0 < fraction <= 1");
  require(u.size() == m_accepted.u.size(), where, "size of u", u.size(), "number of dofs");
  u = (m_u_start + fraction * (u - m_u_start)).eval();
  shorten(model(), m_accepted.contact, fraction, m_corrector.state());
  const Eigen::VectorXd& start = m_prescribed_start.value;
  m_prescribed.t = m_t + fraction * m_dt;
  m_prescribed.value = (start + fraction * (m_prescribed.value - start)).eval();
  m_dt *= fraction;
}

template <int Dim> double ContactRun<Dim>::contact_width() const {
  double width = 0;
  for (int t = 0; t < static_cast<int>(m_setup->tools().size()); ++t)
    width = std::max(width, burnish::contact_width(model(), body(), m_accepted.contact, m_accepted.u, t));
  return width;
}

template <int Dim> double ContactRun<Dim>::contact_speed() const {
  const StepHistory<Dim>& history = m_accepted.history;
  return history.dt == 0 ? 0 : burnish::contact_speed(model(), m_accepted.contact, history.q_old, history.dt);
}

template class ContactRun<2>;
template class ContactRun<3>;

} // namespace burnish

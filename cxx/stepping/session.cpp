#include "stepping/session.hpp"
#include "base/error.hpp"
#include "base/formula.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

template <int Dim>
Session<Dim>::Session(Mesh<Dim> mesh, std::vector<Facet<2>> surface, std::vector<char> fixed,
                      StepOptions options)
    : m_mesh(std::make_shared<const Mesh<Dim>>(std::move(mesh))), m_surface(std::move(surface)),
      m_fixed(std::move(fixed)), m_options(options) {
  require(static_cast<int>(m_fixed.size()) == m_mesh->num_dofs(), "contact", "number of fixed flags",
          m_fixed.size(), "one per degree of freedom");
  for (const int node : nodes_along(m_surface)) {
    bool held = true;
    for (int c = 0; c < Dim; ++c) held = held && m_fixed[Dim * node + c];
    if (!held) m_candidates.push_back(node);
  }
  require(!m_candidates.empty(), "contact", "number of candidate nodes", 0,
          "at least one node on the labels that is not fixed");
  m_u = m_R = Eigen::VectorXd::Zero(m_mesh->num_dofs());
}

template <int Dim>
void Session<Dim>::add_tool(std::shared_ptr<DrivenTool<Dim>> tool,
                            std::shared_ptr<const FrictionLaw> friction, const std::vector<Facet<2>>& reach) {
  if (m_corrector) fail("contact.add", "tools must be added before the first step");
  tool->tool();
  for (const auto& other : m_tools)
    if (other->name() == tool->name()) fail("contact.add", "tool \"" + tool->name() + "\" is already there");
  m_tools.push_back(std::move(tool));
  m_model.friction.push_back(std::move(friction));
  m_model.reach.emplace_back();
  if (reach.empty()) return;
  const std::vector<int> nodes = nodes_along(reach);
  for (const int candidate : m_candidates)
    m_model.reach.back().push_back(std::find(nodes.begin(), nodes.end(), candidate) != nodes.end());
}

template <int Dim> void Session<Dim>::start() {
  if (m_corrector) return;
  m_model.candidates = m_candidates;
  for (const int node : m_candidates) {
    m_model.held.emplace_back();
    for (int c = 0; c < Dim; ++c) m_model.held.back()[c] = m_fixed[Dim * node + c];
  }
  m_model.first.assign(1, 0);
  for (const auto& tool : m_tools) {
    m_model.tools.push_back(tool->shared_tool());
    m_model.first.push_back(m_model.first.back() + static_cast<int>(tool->q().size()));
  }
  const auto& X = m_mesh->X;
  m_corrector = std::make_unique<Corrector<Dim>>(
      m_model, Eigen::Map<const Eigen::VectorXd>(X.data(), static_cast<Eigen::Index>(X.size())), m_fixed,
      m_options, m_mesh->axisymmetric);
  m_locator = std::make_unique<MeshLocator<Dim>>(*m_mesh);
  m_condensation = std::make_unique<Condensation<Dim>>(m_corrector->model(), m_corrector->body());
  m_accepted = m_corrector->state();
  for (std::size_t t = 0; t < m_tools.size(); ++t)
    m_accepted.q.segment(m_model.first[t], m_tools[t]->q().size()) = m_tools[t]->q();
  warn_of_curvature();
}

// Smallest gap of a tool at m_accepted.q, the nodes that have it, and its change with coordinate k of the
// tool.
template <int Dim>
typename Session<Dim>::SmallestGap Session<Dim>::smallest_gap(int tool, int k, const Eigen::VectorXd& u) {
  const auto& body = m_corrector->body();
  const auto pose = m_model.tools[tool]->coordinates().pose(m_model.tool_q(m_accepted.q, tool));
  const double same = 1e-9 * body.spacing;
  SmallestGap result;
  for (std::size_t i = 0; i < m_candidates.size(); ++i) {
    if (!m_model.may_touch(static_cast<int>(i), tool)) continue;
    const auto foot =
        m_model.tools[tool]->closest_point(pose, body.position(u, m_candidates[i]), m_accepted.nodes[i].s);
    const auto p = m_model.tools[tool]->surface(pose, foot.s);
    result.fastest = std::max(result.fastest, p.x_q.col(k).norm());
    result.bending = std::max(result.bending, 0.5 * p.x_qq[static_cast<std::size_t>(k)].col(k).norm());
    if (!result.nodes.empty() && foot.gap >= result.gap + same) continue;
    if (result.nodes.empty() || foot.gap < result.gap - same) result.nodes.clear();
    result.gap = result.nodes.empty() ? foot.gap : std::min(result.gap, foot.gap);
    result.slope = -p.n.dot(p.x_q.col(k));
    result.lever = p.x_q.col(k).norm();
    result.nodes.push_back(i);
    auto& node = m_accepted.nodes[i];
    if (node.tool == tool || !in_contact(node.state)) node.s = foot.s; // not where another tool touches
  }
  return result;
}

template <int Dim>
double Session<Dim>::approach(int tool, const std::string& coordinate, const Eigen::VectorXd& u) {
  require(tool >= 0 && tool < static_cast<int>(m_tools.size()), "contact.approach", "tool", tool,
          "a tool that was added");
  require(u.size() == m_u.size(), "contact.approach", "size of u", u.size(), "number of dofs");
  start();
  const int k = m_tools[tool]->index(coordinate);
  double& q = m_accepted.q[m_model.first[tool] + k];
  m_accepted.q.segment(m_model.first[tool], m_tools[tool]->q().size()) = m_tools[tool]->q();
  for (int iteration = 0; iteration < 1000; ++iteration) { // Newton on the smallest gap as a function of q^k
    const SmallestGap least = smallest_gap(tool, k, u);
    if (std::abs(least.gap) < 1e-9 * m_corrector->body().spacing) {
      check_from_outside(tool, least.nodes, u);
      for (const std::size_t i : least.nodes) {
        auto& node = m_accepted.nodes[i];
        node.tool = tool;
        node.s_ref = node.s;
        const bool slides = m_model.law(static_cast<int>(i), tool).frictionless();
        node.state = slides ? NodeState::SLIDING : NodeState::STICKING;
      }
      m_tools[tool]->q()[k] = q;
      m_u = u;
      return q;
    }
    if (std::abs(least.slope) < 1e-9 * least.lever) break;
    // no point of the tool moves much further than the gap, to second order, lest a leap past a dead center
    // or through the body ends at another touch than the first one
    const double way = std::max(1.5 * std::abs(least.gap), 0.05 * m_corrector->body().spacing);
    const double most =
        2 * way / (least.fastest + std::sqrt(least.fastest * least.fastest + 4 * least.bending * way));
    q -= std::clamp(least.gap / least.slope, -most, most);
  }
  fail_approach(tool, coordinate);
}

template <int Dim> Program Session<Dim>::read_program() {
  Program program;
  program.value.resize(m_model.num_coordinates());
  for (std::size_t t = 0; t < m_tools.size(); ++t) {
    const Prescription& prescription = m_tools[t]->prescription();
    prescription.check_complete();
    for (int k = 0; k < prescription.size(); ++k) {
      program.is_motion.push_back(prescription.is_motion(k));
      program.value[m_model.first[t] + k] = prescription.value(k);
    }
  }
  return program;
}

// A coordinate under force goes on as in the last step, or stays where it is if its formulas end there.
template <int Dim> Prediction<Dim> Session<Dim>::predicted(const Eigen::VectorXd& u) {
  const auto with = [&](const StepHistory<Dim>& history) {
    return predict(m_model, m_corrector->body(), *m_locator, *m_mesh, m_program, m_accepted, u, history, m_dt,
                   m_stepping == Stepping::IMPLICIT);
  };
  try {
    return with(m_history);
  } catch (const FormulaDomainError&) {
    StepHistory<Dim> still = m_history;
    still.dq.setZero();
    return with(still);
  }
}

template <int Dim> void Session<Dim>::begin(Eigen::VectorXd& u, double t, double dt, Stepping stepping) {
  require(std::isfinite(dt) && dt > 0, "contact.begin", "dt", dt, "> 0");
  require(u.size() == m_u.size(), "contact.begin", "size of u", u.size(), "number of dofs");
  if (!u.allFinite()) fail("contact.begin", "the displacement holds NaN or Inf");
  const bool first = !m_corrector || m_history.dt == 0;
  start();
  if (!first) check_not_placed();
  for (std::size_t t = 0; first && t < m_tools.size(); ++t) // placed after another tool's approach
    m_accepted.q.segment(m_model.first[t], m_tools[t]->q().size()) = m_tools[t]->q();
  m_program = read_program();
  drop_unresisted(m_program);
  check_support(m_program);
  check_independent(m_program);
  if (first) check_not_inside(u);
  m_t = t;
  m_dt = dt;
  m_largest_dt = std::max(m_largest_dt, dt);
  m_stepping = stepping;
  m_u = u;
  share_surface();
  match_old_program();
  auto prediction = stepping == Stepping::RATES ? resting(u) : predicted(u);
  u = prediction.u;
  const bool keep = stepping == Stepping::EVENT && m_steps_since_factor < 2;
  m_corrector->begin(m_program, prediction.state, std::move(prediction.entry), stepping == Stepping::IMPLICIT,
                     keep);
}

// An iterate where a formula has no value fails the step: a shorter one may stay clear of it.
template <int Dim> StepStatus Session<Dim>::check(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  try {
    return m_corrector->check(u, R);
  } catch (const FormulaDomainError& error) {
    return m_corrector->give_up(error.what());
  }
}
template <int Dim> StepStatus Session<Dim>::correct(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  try {
    return m_corrector->correct(u, R);
  } catch (const FormulaDomainError& error) {
    return m_corrector->give_up(error.what());
  }
}

template <int Dim>
FactorStatus Session<Dim>::factorize(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u) {
  m_steps_since_factor = 0;
  return m_corrector->factorize(K, u);
}

template <int Dim>
void Session<Dim>::accept(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                          const std::vector<ContactEvent<Dim>>& events) {
  require(u.size() == m_u.size() && R.size() == m_u.size(), "contact.accept", "size of the arrays", u.size(),
          "number of dofs");
  auto& state = m_corrector->state();
  if (m_stepping == Stepping::IMPLICIT) {
    const auto changes = state_changes(model(), m_corrector->body(),
                                       StepEnds<Dim>{&m_accepted, &state, &m_u, &u, &m_R, &R, m_t, m_dt});
    m_log.insert(m_log.end(), changes.begin(), changes.end());
  }
  const auto poses = model().poses(state.q);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    auto& node = state.nodes[i];
    node.slip_rate = 0;
    if (node.state != NodeState::SLIDING) continue;
    const double length = model().tools[node.tool]->surface(poses[node.tool], node.s).x_s.col(0).norm();
    node.slip_rate = (node.s - node.s_ref)[0] * length / m_dt;
  }
  m_history = {u - m_u, state.q - m_accepted.q, m_accepted.q, m_dt};
  m_u = u;
  m_R = R;
  if (m_stepping == Stepping::RATES) m_corrector->measure(u, R);
  if (m_stepping != Stepping::IMPLICIT) {
    settle_released(model(), m_corrector->body(), u,
                    m_corrector->options().gap_tolerance * m_corrector->body().spacing, state);
    apply_events(model(), m_corrector->body(), events, u, state); // released now: leaves in the next step
    keep_support(state, events);
    m_log.insert(m_log.end(), events.begin(), events.end());
  }
  note_conflicts(state, u);
  note_ends(state, u);
  m_accepted = state;
  m_load_scale = m_corrector->load_scale();
  m_program_old = m_program;
  ++m_steps_since_factor;
  for (std::size_t t = 0; t < m_tools.size(); ++t) {
    m_tools[t]->q() = m_model.tool_q(m_accepted.q, static_cast<int>(t));
    m_tools[t]->generalized_force() =
        m_model.tool_q(m_corrector->last_balance().tool_force, static_cast<int>(t));
  }
}

template <int Dim> void Session<Dim>::revert() {
  if (!m_corrector) return;
  m_corrector->state() = m_accepted;
  m_corrector->set_load_scale(m_load_scale); // the load of a step that is not accepted does not count
  if (m_stepping == Stepping::IMPLICIT) m_corrector->drop_factor(); // an event step only becomes shorter
}

template <int Dim> double Session<Dim>::contact_width() const {
  double width = 0;
  for (std::size_t t = 0; m_corrector && t < m_tools.size(); ++t)
    width = std::max(width, m_corrector->contact_width(m_u, static_cast<int>(t)));
  return width;
}

// Tangential motion of the contact's middle with the tool's carrier in the last step.
template <int Dim> double Session<Dim>::contact_speed() const {
  double speed = 0;
  if (m_history.dt == 0) return 0;
  const auto poses = m_model.poses(m_accepted.q);
  for (std::size_t t = 0; t < m_tools.size(); ++t) {
    const auto carrier =
        m_model.tools[t]->coordinates().carrier(m_model.tool_q(m_history.q_old, static_cast<int>(t)),
                                                m_model.tool_q(m_accepted.q, static_cast<int>(t)));
    for (std::size_t i = 0; i < m_accepted.nodes.size(); ++i) {
      const auto& node = m_accepted.nodes[i];
      if (!in_contact(node.state) || node.tool != static_cast<int>(t)) continue;
      const auto p = m_model.tools[t]->surface(poses[t], node.s);
      const Vector<Dim> moved = p.x - carrier.inverse()(p.x);
      speed = std::max(speed, std::abs(moved.dot(p.x_s.col(0).normalized())) / m_history.dt);
    }
  }
  return speed;
}

template class Session<2>;

} // namespace burnish

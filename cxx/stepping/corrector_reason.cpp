// Why a step has not converged, in words.
#include "stepping/corrector.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace burnish {
namespace {

// What a residual that stays too large comes from.
template <int Dim>
std::string reason_of_residual(const Balance& balance, const BodyView<Dim>& body, double rounding,
                               double allowed, double load, double last_residual) {
  constexpr double nothing = 1e-8;   // depth of the load under the largest stiffness, over the spacing
  constexpr double falls = 0.5;      // ratio of the last residuals
  constexpr double exhausted = 1e-3; // part of the friction that is left
  std::ostringstream text;
  if (rounding > allowed) {
    const double place = 4 * std::numeric_limits<double>::epsilon() * body.X.cwiseAbs().maxCoeff();
    const double depth = load / rounding * place;
    text << ": rounding leaves up to " << rounding;
    if (depth < nothing * body.spacing)
      text << ", the load of " << load << " is next to nothing: look at its size and units";
    else
      text << ", the mesh is too large or too slender for this load";
  } else if (last_residual >= 0 && balance.residual < falls * last_residual) {
    text << ": the residual still falls, allow more iterations (maxiterations=)";
  } else if (balance.worst_coordinate >= 0 && balance.friction_limit > 0 &&
             balance.friction > (1 - exhausted) * balance.friction_limit) {
    text << ": all friction is used up, nothing is left for a coordinate under force";
  }
  return text.str();
}

// Whether a coordinate under force still moves by a good part of its first increment.
bool moves_on(const PrescribedValues& prescribed, const Eigen::VectorXd& last, const Eigen::VectorXd& first) {
  constexpr double part = 0.1;
  if (first.size() != last.size()) return false;
  for (Eigen::Index k = 0; k < last.size(); ++k)
    if (!prescribed.is_motion[k] && std::abs(last[k]) > part * std::abs(first[k])) return true;
  return false;
}

// A node whose friction is beyond its limit if it sticks and along its slip if it slides: with friction that large a body may
// have no equilibrium near the last one. "": none.
template <int Dim>
std::string wedged_node(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                        const BodyView<Dim>& body, const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                        double tolerance) {
  if (R.size() == 0 || u.size() != R.size()) return "";
  const auto poses = model.poses(state.q);
  const std::vector<DecidingForce<Dim>> deciding = deciding_forces(model, state, poses, R);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const ContactNode<Dim>& node = state.nodes[i];
    if (!in_contact(node.state) || node.tied || model.law(static_cast<int>(i), node.tool).frictionless())
      continue;
    const int candidate = static_cast<int>(i), mesh_node = model.candidates[i];
    const ContactPoint<Dim> at = contact_point(model, poses, node);
    const SurfaceForce<Dim>& part = deciding[i].force;
    const double reserve = model.law(candidate, node.tool).reserve(part, deciding[i].area);
    const bool wedged =
        sticks(node.state) ? reserve < -tolerance : part.N > 0 && slip_of(model, node).dot(at.m) < 0;
    if (!wedged) continue;
    std::ostringstream text;
    text << ": the forces balance, but states cycle: node " << mesh_node << " at "
         << body.position(u, mesh_node).transpose() << " can neither stick nor slide, since its friction of "
         << part.T.norm() << " beside a normal force of " << part.N
         << " is so large that it wedges: there may be no equilibrium near the last one";
    return text.str();
  }
  return "";
}

} // namespace

template <int Dim> std::string Corrector<Dim>::reason_of_failure(double scale) const {
  std::ostringstream text;
  text << "no convergence in " << m_iteration << " iterations: residual " << m_balance.residual
       << ", allowed " << allowed(scale) << ", " << m_balance.inconsistent << " inconsistent contact states";
  if (m_balance.residual > allowed(scale)) {
    const std::string why =
        reason_of_residual(m_balance, m_body, m_rounding, allowed(scale), scale, m_last_residual);
    const bool goes_on =
        m_q_before.size() == m_state.q.size() && moves_on(m_prescribed, m_state.q - m_q_before, m_first_dq);
    text << why;
    if (goes_on && m_rounding <= allowed(scale))
      text << (why.empty() ? ": " : "; ") << "the tool goes on moving under its force, a limit load";
  } else if (m_balance.friction_limit > 0 &&
             std::count(m_prescribed.is_motion.begin(), m_prescribed.is_motion.end(), 0) > 0 &&
             m_balance.friction > (1 + m_options.tolerance) * m_balance.friction_limit) {
    text << ": the forces balance with friction that adds up to " << m_balance.friction
         << " over the contact nodes, whose limits add up to " << m_balance.friction_limit
         << ": too little to balance a coordinate under force";
  } else {
    const std::string wedged = wedged_node(m_model, m_state, m_body, m_u_before, m_R,
                                           m_options.state_force * m_options.tolerance * scale);
    text << (wedged.empty() ? ": the forces balance, but states cycle" : wedged);
  }
  if (m_options.friction_tangent != FrictionTangent::CONSISTENT)
    text << "; frictiontangent=\"consistent\" needs fewer iterations";
  return text.str();
}

template <int Dim> std::string Corrector<Dim>::singular_reason(const WindowSolution<Dim>& solution) const {
  if (solution.weakest_coordinate >= 0)
    return "nothing resists " + m_model.coordinate(solution.weakest_coordinate) + " under force control";
  return m_floating ? "singular contact block: neither supports nor tools constrain the workpiece"
                    : "singular contact block";
}

template std::string Corrector<2>::reason_of_failure(double) const;
template std::string Corrector<3>::reason_of_failure(double) const;
template std::string Corrector<2>::singular_reason(const WindowSolution<2>&) const;
template std::string Corrector<3>::singular_reason(const WindowSolution<3>&) const;

} // namespace burnish

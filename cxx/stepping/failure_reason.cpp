#include "stepping/failure_reason.hpp"
#include "stepping/rigid_modes.hpp"
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <sstream>

namespace burnish {
namespace {

constexpr double SHORT = 1e-3; // of the largest step: changes of motion and force are small by then

// A force that changes by much of itself however short the step is. Formulas are judged by nobody.
template <int Dim> std::string force_jump(const ContactSetup<Dim>& setup, const FailedStep<Dim>& step) {
  constexpr double much = 1e-2; // change over the larger of both forces
  const Eigen::VectorXd &now = step.prescribed->value, &before = step.before->value;
  if (now.size() != before.size()) return "";
  for (Eigen::Index k = 0; k < now.size(); ++k) {
    if (step.prescribed->is_motion[k] || step.before->is_motion[k]) continue;
    if (!step.prescribed->formula.empty() && step.prescribed->formula[k]) continue;
    const double largest = std::max(std::abs(now[k]), std::abs(before[k]));
    if (!(std::abs(now[k] - before[k]) > much * largest)) continue;
    std::ostringstream text;
    text << "the program changes the force on " << setup.model().coordinate(static_cast<int>(k)) << " from "
         << before[k] << " to " << now[k] << " at once at t = " << step.t << ": let it change over some time";
    return text.str();
  }
  return "";
}

} // namespace

template <int Dim> std::string program_jump(const ContactSetup<Dim>& setup, const FailedStep<Dim>& step) {
  constexpr double jump = 1e-2; // motion of a tool's points that is not, over the spacing of candidates
  const auto& q = step.state->q;
  if (step.dt > SHORT * step.largest_dt || q.size() != step.prescribed->value.size()) return "";
  const auto poses = setup.model().poses(q);
  for (std::size_t t = 0; t < setup.tools().size(); ++t)
    for (std::size_t k = 0; k < poses[t].origin_q.size(); ++k) {
      const int at = setup.model().first[t] + static_cast<int>(k);
      const double change = step.prescribed->value[at] - q[at];
      const double lever = poses[t].origin_q[k].norm() +
                           poses[t].R_q[k].norm() * setup.model().tools[t]->surface().length_scale();
      if (!step.prescribed->is_motion[at] || std::abs(change) * lever < jump * setup.body().spacing) continue;
      std::ostringstream text;
      text << "the program moves " << setup.model().coordinate(at) << " by " << change << " at once, from "
           << q[at] << " at t = " << step.t << ": after a force go on from value(...)";
      return text.str();
    }
  return force_jump(setup, step);
}

template <int Dim>
std::string unheld_workpiece(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                             const Eigen::VectorXd& u) {
  constexpr double none = 1e-6; // pivot over the largest: the motion meets no resistance
  constexpr int modes = RigidModes<Dim>::count;
  if (constrains_rigid_motions(setup.body())) return "";
  const auto& body = setup.body();
  const RigidModes<Dim> motions(body, body.position(u, setup.candidates()[0]));
  Eigen::Matrix<double, modes, modes> resisted = motions.resisted_by_supports(body, u);
  const auto poses = setup.model().poses(state.q);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    const auto m = motions(body.position(u, setup.candidates()[i]));
    const Vector<Dim> n = setup.model().tools[node.tool]->point(poses[node.tool], node.place).n;
    resisted +=
        sticks(node.state) ? (m.transpose() * m).eval() : (m.transpose() * n * n.transpose() * m).eval();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, modes, modes>> solver(resisted);
  if (solver.eigenvalues()[0] > none * solver.eigenvalues()[modes - 1]) return "";
  return "the workpiece is not held: neither supports (fixed=) nor the nodes in contact take all its rigid "
         "motions";
}

template <int Dim>
std::string pulling_force(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                          const PrescribedValues& prescribed) {
  constexpr double along = 0.5; // part of a node's motion by the coordinate that is normal to the tool
  const auto& model = setup.model();
  const auto poses = model.poses(state.q);
  for (int k = 0; k < static_cast<int>(prescribed.value.size()); ++k) {
    if (prescribed.is_motion[k] || prescribed.value[k] == 0 || model.coupling_of(k) || prescribed.is_held(k))
      continue;
    bool any = false, all = true;
    for (const auto& node : state.nodes) {
      if (!in_contact(node.state) || node.tool != model.tool_of(k)) continue;
      const auto p = model.tools[node.tool]->point(poses[node.tool], node.place);
      const Vector<Dim> motion = p.x_q.col(k - model.first[node.tool]);
      any = true;
      all = all && motion.dot(p.n) * (prescribed.value[k] > 0 ? 1 : -1) < -along * motion.norm();
    }
    if (!any || !all) continue;
    std::ostringstream text;
    text << "the force " << prescribed.value[k] << " on " << model.coordinate(k)
         << " draws the tool away from the workpiece, which only pushes";
    return text.str();
  }
  return "";
}

template <int Dim>
std::string last_equilibrium(const ContactSetup<Dim>& setup, const PrescribedValues& prescribed,
                             const Eigen::VectorXd& q, const Eigen::VectorXd& force, double t) {
  std::ostringstream text;
  text << "the last equilibrium is that of t = " << t;
  bool any = false;
  for (const char kind : {0, 1}) { // forces first
    for (int k = 0; k < static_cast<int>(q.size()) && !(kind == 1 && any); ++k) {
      if (prescribed.is_motion[k] != kind || force[k] == 0) continue;
      if (kind == 0 && prescribed.value[k] == 0) continue;
      text << ", " << setup.model().coordinate(k) << " = " << q[k] << " with force " << force[k];
    }
    for (int k = 0; k < static_cast<int>(q.size()); ++k)
      any = any || (prescribed.is_motion[k] == 0 && prescribed.value[k] != 0);
  }
  return text.str();
}

template <int Dim> std::string end_of_tool(const ContactSetup<Dim>& setup, const ContactState<Dim>& state) {
  constexpr double near = 0.5; // of the spacing of candidates
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    const auto& tool = *setup.model().tools[node.tool];
    const double away = tool.surface().distance_to_end(node.place);
    if (away > near * setup.body().spacing) continue;
    std::ostringstream text;
    text << "; node " << setup.candidates()[i] << " in contact is " << away
         << " from the end of the profile of tool \"" << tool.name()
         << "\", where the contact ends with a jump: let the profile go on and curve away from the "
         << "workpiece (chain= with a fillet)";
    return text.str();
  }
  return "";
}

template <int Dim> std::string hangs_on_few(const ContactSetup<Dim>& setup, const ContactState<Dim>& state) {
  constexpr long few = 4;
  if (constrains_rigid_motions(setup.body())) return "";
  const long touching = std::count_if(state.nodes.begin(), state.nodes.end(),
                                      [](const auto& node) { return in_contact(node.state); });
  if (touching == 0 || touching > few) return "";
  std::ostringstream text;
  text << "; the workpiece, to which supports leave a rigid motion, hangs on " << touching
       << (touching == 1 ? " node" : " nodes")
       << " in contact and may slip from one to the next: a holder, another support, or a finer mesh there";
  return text.str();
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template std::string program_jump<Dim>(const ContactSetup<Dim>&, const FailedStep<Dim>&);                  \
  template std::string end_of_tool<Dim>(const ContactSetup<Dim>&, const ContactState<Dim>&);                 \
  template std::string hangs_on_few<Dim>(const ContactSetup<Dim>&, const ContactState<Dim>&);                \
  template std::string unheld_workpiece<Dim>(const ContactSetup<Dim>&, const ContactState<Dim>&,             \
                                             const Eigen::VectorXd&);                                        \
  template std::string pulling_force<Dim>(const ContactSetup<Dim>&, const ContactState<Dim>&,                \
                                          const PrescribedValues&);                                          \
  template std::string last_equilibrium<Dim>(const ContactSetup<Dim>&, const PrescribedValues&,              \
                                             const Eigen::VectorXd&, const Eigen::VectorXd&, double);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish

#include "checks/balance_check.hpp"
#include "contact/balance.hpp"
#include "contact/resultant.hpp"
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace burnish {

namespace {

template <int Dim> double size_of_body(const AcceptedStep<Dim>& step, Vector<Dim>& middle) {
  const int nodes = step.mesh.num_nodes;
  middle.setZero();
  for (int a = 0; a < nodes; ++a) middle += step.body.position(step.u, a) / nodes;
  double size = 0;
  for (int a = 0; a < nodes; ++a)
    size = std::max(size, (step.body.position(step.u, a) - middle).squaredNorm());
  return std::sqrt(size);
}

// A number beyond its bounds, if it is the worst so far.
Finding* beyond(FindingList& findings, const std::string& name, const std::string& subject, double value,
                double noted, double bound, double t) {
  if (!(value > noted)) return nullptr;
  Finding* finding =
      findings.report(name, subject, value > bound ? Severity::UNTRUSTED : Severity::WARNING, value, t);
  if (!finding) return nullptr;
  finding->value = value;
  finding->bound = value > bound ? bound : noted;
  return finding;
}

constexpr double CONVERGED = 2; // an iteration leaves no node with more tolerances
constexpr const char* CAUSE = ": the scheme does not come back to equilibrium; take shorter steps, or "
                              "scheme=\"implicit\"";

// What the nodes are left with that nothing holds. An iteration ends with less than its tolerance; pure rates never look.
template <int Dim>
void look_at_nodes(const AcceptedStep<Dim>& step, const Eigen::VectorXd& left, double load,
                   const CheckOptions& options, CheckState& state, FindingList& findings) {
  int worst = 0;
  double largest = 0, sum = 0;
  for (int a = 0; a < step.mesh.num_nodes; ++a) {
    const double r = left.segment<Dim>(Dim * a).norm() / load;
    sum += r;
    if (r > largest) largest = r, worst = a;
  }
  state.largest("residual", sum);
  if (largest < CONVERGED * step.tolerance) return;
  const double least = options.imbalance_tolerances * step.tolerance;
  Finding* finding = beyond(findings, "residual", "", sum, std::max(options.residual, least),
                            std::max(options.residual_far, least), step.t);
  if (!finding) return;
  const Vector<Dim> x = step.body.position(step.u, worst);
  finding->place = step.place_of(x);
  std::ostringstream text;
  text << "the nodes are left with " << sum << " of the load, which nothing holds, most" << step.at(x)
       << CAUSE;
  finding->text = text.str();
}

// Of the whole run, over the largest force: a tool that has hardly touched carries less than what the residual leaves.
double share_missed(const UnmetState& unmet, double least) {
  const double of_load = unmet.load > 0 ? unmet.residual / (least * unmet.load) : 0;
  return unmet.of > 0 ? std::min(of_load, unmet.missed / unmet.of) : of_load;
}

void keep(UnmetState& known, const UnmetState& now) {
  known.of = std::max(known.of, now.of);
  known.load = std::max(known.load, now.load);
  if (!(now.missed > known.missed)) return;
  known.missed = now.missed;
  known.residual = now.residual;
  known.t = now.t;
}

// Friction of all nodes together beyond what they can bear together.
template <int Dim>
void look_at_friction(const AcceptedStep<Dim>& step, const Balance& now, const CheckOptions& options,
                      FindingList& findings) {
  if (!std::isfinite(now.friction_limit) || !(now.friction_limit > options.unmet_least * step.load)) return;
  const double least = options.imbalance_tolerances * step.tolerance;
  const double value = now.friction / now.friction_limit - 1;
  Finding* finding = beyond(findings, "friction sum", "", value, std::max(options.unmet, least),
                            std::max(options.unmet_far, least), step.t);
  if (!finding) return;
  std::ostringstream text;
  text << "the friction of all nodes exceeds its limit by " << value << " of it, t = " << step.t << CAUSE;
  finding->text = text.str();
}

// What the prescribed forces of the tools are missed by. At the end of an event step the states are those after its events: a node
// that touches there adds what a heavier tool's tolerance left of it, so the force is that of the equilibrium.
template <int Dim>
void look_at_tools(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                   FindingList& findings) {
  if (!step.prescribed) return;
  const Balance now = balance(step.model, step.body, step.contact, *step.prescribed, step.u, step.R, {});
  const double least = options.imbalance_tolerances * step.tolerance;
  state.unmet.resize(static_cast<std::size_t>(now.tool_residual.size()));
  double worst = 0;
  for (int k = 0; k < static_cast<int>(now.tool_residual.size()); ++k) {
    if (step.prescribed->is_motion[k] || step.model.coupling_of(k)) continue;
    const bool formula = !step.prescribed->formula.empty() && step.prescribed->formula[k];
    UnmetState& unmet = state.unmet[static_cast<std::size_t>(k)];
    const double residual = std::abs(now.tool_residual[k]), wanted = step.prescribed->value[k],
                 load = now.tool_load[step.model.tool_of(k)];
    // a formula follows what is found: over the load of the tool
    if (formula)
      keep(unmet, {residual, 0, residual * options.unmet_least, load, step.t});
    else
      keep(unmet, {std::abs(step.generalized_force[k] - wanted), std::abs(wanted), residual, load, step.t});
    const double value = share_missed(unmet, options.unmet_least);
    worst = std::max(worst, value);
    const std::string name = step.model.coordinate(k);
    findings.withdraw("unmet force", name);
    Finding* finding = beyond(findings, "unmet force", name, value, std::max(options.unmet, least),
                              std::max(options.unmet_far, least), unmet.t);
    if (!finding) continue;
    std::ostringstream text;
    text << "the force of " << name << " is missed by " << value
         << " of the largest prescribed, t = " << unmet.t << CAUSE;
    finding->text = text.str();
  }
  state.measured["unmet force"] = worst;
  look_at_friction(step, now, options, findings);
}

} // namespace

// The internal forces of a body balance one another; what the free nodes have left over does not, nor an internal force
// that is none (a law or an assembly of a script).
template <int Dim>
void BalanceCheck<Dim>::look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                             FindingList& findings) {
  const double load = std::max(step.load, step.R.cwiseAbs().maxCoeff());
  if (!(load > 0)) return;
  Vector<Dim> middle;
  const double size = size_of_body(step, middle);
  const Eigen::VectorXd held = contact_forces(step.model, step.contact, step.R) +
                               support_forces(step.model, step.body, step.contact, step.R);
  look_at_nodes<Dim>(step, step.R - held, load, options, state, findings);
  look_at_tools(step, options, state, findings);
  Resultant<Dim> total = resultant<Dim>(step.body, step.u, step.internal - step.R + held, middle);
  if (step.mesh.axisymmetric) total = of_ring(total);
  const double value =
      std::max(total.force.cwiseAbs().maxCoeff(), total.moment.cwiseAbs().maxCoeff() / size) / load;
  state.largest("balance", value);
  const double bound = std::max(options.imbalance, options.imbalance_tolerances * step.tolerance);
  Finding* finding = beyond(findings, "balance", "", value, options.imbalance_noted, bound, step.t);
  if (!finding) return;
  std::ostringstream text;
  text << "forces and moments on the workpiece are out of balance by " << value
       << " of the load, t = " << step.t;
  if (value <= bound)
    text << ": so far off may the forces of the tools be; take a smaller tolerance= of rcContact";
  finding->text = text.str();
}

template class BalanceCheck<2>;
template class BalanceCheck<3>;

} // namespace burnish

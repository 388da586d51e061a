// Forces and moments on the workpiece (ALGORITHMS.md 16.1).
#include "contact/balance.hpp"
#include "base/sentence.hpp"
#include "contact/resultant.hpp"
#include "diagnosis/accepted/no_load.hpp"
#include "diagnosis/observers.hpp"
#include <algorithm>
#include <cmath>
#include <string>

namespace burnish {

namespace {

template <int Dim> double size_of_body(const AcceptedStep<Dim>& step, Vector<Dim>& middle) {
  const int nodes = step.mesh().num_nodes;
  middle.setZero();
  for (int a = 0; a < nodes; ++a) middle += step.body().position(step.u, a) / nodes;
  double size = 0;
  for (int a = 0; a < nodes; ++a)
    size = std::max(size, (step.body().position(step.u, a) - middle).squaredNorm());
  return std::sqrt(size);
}

constexpr double TOLERANCES = 20; // of the residual: what adds up to less is no imbalance
constexpr double NOTED = 2e-3,
                 IMBALANCE = 1e-2;    // forces and moments out of balance over the load: warning, untrusted
constexpr Bounds RESIDUAL{0.01, 0.1}; // what the nodes that nothing holds are left with, sum over the load
constexpr Bounds UNMET{5e-3, 0.05};   // what a prescribed force of a tool is missed by, over itself ...
constexpr double UNMET_LEAST = 0.05;  // ... over this part of the tool's load, if the force is less

// What a prescribed force was missed by, the largest of the run.
struct UnmetState {
  double missed = 0, of = 0;     // largest difference; largest force prescribed [force, force length]
  double residual = 0, load = 0; // the difference over its lever; load of the tool, the largest ones [force]
  double t = 0;                  // of the largest difference
  BURNISH_FIELDS(missed, of, residual, load, t)
};

template <int Dim> class BalanceCheck final : public ObserverOf<BalanceCheck<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_unmet)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;

private:
  std::vector<UnmetState> m_unmet; // per coordinate
};

constexpr double CONVERGED = 2; // an iteration leaves no node with more tolerances
constexpr const char* CAUSE = ": the scheme does not come back to equilibrium; take shorter steps, or "
                              "scheme=\"implicit\"";

// What the nodes are left with that nothing holds. An iteration ends with less than its tolerance; pure rates never look.
template <int Dim>
void look_at_nodes(const AcceptedStep<Dim>& step, const Eigen::VectorXd& left, double load,
                   FindingList& findings) {
  int worst = 0;
  double largest = 0, sum = 0;
  for (int a = 0; a < step.mesh().num_nodes; ++a) {
    const double r = left.segment<Dim>(Dim * a).norm() / load;
    sum += r;
    if (r > largest) largest = r, worst = a;
  }
  findings.largest("residual", sum);
  if (largest < CONVERGED * step.allowed.relative) return;
  const double least = TOLERANCES * step.allowed.relative;
  Finding* finding = findings.beyond(
      "residual", "", sum, {std::max(RESIDUAL.noted, least), std::max(RESIDUAL.far, least)}, step.t);
  if (!finding) return;
  const Vector<Dim> x = step.body().position(step.u, worst);
  finding->place = step.place_of(x);
  finding->text =
      sentence("the nodes are left with ", sum, " of the load, which nothing holds, most", step.at(x), CAUSE);
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
void look_at_friction(const AcceptedStep<Dim>& step, const Balance& now, FindingList& findings) {
  if (!std::isfinite(now.friction_limit) || !(now.friction_limit > UNMET_LEAST * step.allowed.load)) return;
  const double least = TOLERANCES * step.allowed.relative;
  const double value = now.friction / now.friction_limit - 1;
  Finding* finding = findings.beyond("friction sum", "", value,
                                     {std::max(UNMET.noted, least), std::max(UNMET.far, least)}, step.t);
  if (!finding) return;
  const auto nodes = std::count_if(step.contact.nodes.begin(), step.contact.nodes.end(),
                                   [](const auto& node) { return in_contact(node.state); });
  const bool tolerated = value * now.friction_limit <= static_cast<double>(nodes) * step.allowed.residual();
  finding->text =
      sentence("the friction of all nodes exceeds its limit by ", value, " of it, t = ", step.t,
               tolerated ? ": every node may by the tolerance, and many add up; take a smaller tolerance= "
                           "of rcContact"
                         : CAUSE);
}

// What the prescribed forces of the tools are missed by. At the end of an event step the states are those after its events: a node
// that touches there adds what a heavier tool's tolerance left of it, so the force is that of the equilibrium.
template <int Dim>
void look_at_tools(const AcceptedStep<Dim>& step, std::vector<UnmetState>& all, FindingList& findings) {
  if (!step.prescribed) return;
  const Balance now =
      balance<Dim>({step.model(), step.body(), step.contact, *step.prescribed, step.u, step.R, {}});
  const double least = TOLERANCES * step.allowed.relative;
  all.resize(static_cast<std::size_t>(now.tool_residual.size()));
  double worst = 0;
  for (int k = 0; k < static_cast<int>(now.tool_residual.size()); ++k) {
    if (step.prescribed->is_motion[k] || step.model().coupling_of(k)) continue;
    const bool formula = !step.prescribed->formula.empty() && step.prescribed->formula[k];
    UnmetState& unmet = all[static_cast<std::size_t>(k)];
    const double residual = std::abs(now.tool_residual[k]), wanted = step.prescribed->value[k],
                 load = now.tool_load[step.model().tool_of(k)];
    // a formula follows what is found: over the load of the tool
    if (formula)
      keep(unmet, {residual, 0, residual * UNMET_LEAST, load, step.t});
    else
      keep(unmet, {std::abs(step.generalized_force[k] - wanted), std::abs(wanted), residual, load, step.t});
    const double value = share_missed(unmet, UNMET_LEAST);
    worst = std::max(worst, value);
    const std::string name = step.model().coordinate(k);
    findings.withdraw("unmet force", name);
    Finding* finding = findings.beyond("unmet force", name, value,
                                       {std::max(UNMET.noted, least), std::max(UNMET.far, least)}, unmet.t);
    if (!finding) continue;
    finding->text = sentence("the force of ", name, " is missed by ", value,
                             " of the largest prescribed, t = ", unmet.t, CAUSE);
  }
  findings.measure("unmet force", worst);
  look_at_friction(step, now, findings);
}

// The internal forces of a body balance one another; what the free nodes have left over does not, nor an internal force
// that is none (a law or an assembly of a script).
template <int Dim> void BalanceCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  const double load = std::max(step.allowed.load, step.R.cwiseAbs().maxCoeff());
  if (is_no_load(step, load)) return;
  Vector<Dim> middle;
  const double size = size_of_body(step, middle);
  const Eigen::VectorXd held = contact_forces(step.model(), step.contact, step.R) +
                               support_forces(step.model(), step.body(), step.contact, step.R);
  look_at_nodes<Dim>(step, step.R - held, load, findings);
  look_at_tools(step, m_unmet, findings);
  if (!step.workpiece) return;
  // in small strains the arms are those of the undeformed body
  const Eigen::VectorXd arms = step.u * (step.workpiece->law().small_strain() ? 0 : 1);
  Resultant<Dim> total = resultant<Dim>(step.body(), arms, step.internal - step.R + held, middle);
  if (step.mesh().axisymmetric) total = of_ring(total);
  const double value =
      std::max(total.force.cwiseAbs().maxCoeff(), total.moment.cwiseAbs().maxCoeff() / size) / load;
  findings.largest("balance", value);
  const double bound = std::max(IMBALANCE, TOLERANCES * step.allowed.relative);
  Finding* finding = findings.beyond("balance", "", value, {NOTED, bound}, step.t);
  if (!finding) return;
  finding->text = sentence("forces and moments on the workpiece are out of balance by ", value,
                           " of the load, t = ", step.t,
                           value > bound ? ""
                                         : ": so far off may the forces of the tools be; take a smaller "
                                           "tolerance= of rcContact");
}

} // namespace

BURNISH_OBSERVER(balance_check, BalanceCheck)

} // namespace burnish

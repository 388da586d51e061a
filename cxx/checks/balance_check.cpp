#include "checks/balance_check.hpp"
#include "contact/resultant.hpp"
#include <algorithm>
#include <sstream>

namespace burnish {

// The internal forces of a body balance one another; what the free nodes have left over does not, nor an internal force
// that is none (a law or an assembly of a script).
template <int Dim>
void BalanceCheck<Dim>::look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                             FindingList& findings) {
  const double load = std::max(step.load, step.R.cwiseAbs().maxCoeff());
  if (!(load > 0)) return;
  const int nodes = step.mesh.num_nodes;
  Vector<Dim> middle = Vector<Dim>::Zero();
  for (int a = 0; a < nodes; ++a) middle += step.body.position(step.u, a) / nodes;
  double size = 0;
  for (int a = 0; a < nodes; ++a)
    size = std::max(size, (step.body.position(step.u, a) - middle).squaredNorm());
  size = std::sqrt(size);
  Eigen::VectorXd force = step.internal - step.R + contact_forces(step.model, step.contact, step.R) +
                          support_forces(step.model, step.body, step.contact, step.R);
  Resultant<Dim> total = resultant(step.body, step.u, force, middle);
  if (step.mesh.axisymmetric) total = of_ring(total);
  const double value =
      std::max(total.force.cwiseAbs().maxCoeff(), total.moment.cwiseAbs().maxCoeff() / size) / load;
  state.largest("balance", value);
  const double bound = std::max(options.imbalance, options.imbalance_tolerances * step.tolerance);
  if (!(value > bound)) return;
  Finding* finding = findings.report("balance", "", Severity::UNTRUSTED, value, step.t);
  if (!finding) return;
  finding->value = value;
  finding->bound = bound;
  std::ostringstream text;
  text << "forces and moments on the workpiece are out of balance by " << value
       << " of the load, t = " << step.t;
  finding->text = text.str();
}

template class BalanceCheck<2>;
template class BalanceCheck<3>;

} // namespace burnish

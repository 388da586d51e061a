#include "workpiece/step_error.hpp"
#include <cmath>

namespace burnish {
namespace {

// The other way through the step: straight in place of the curved path, or substeps in place of a single return.
UpdateOptions other_way(UpdateOptions options) {
  if (options.update == StressUpdate::SUBSTEPPED)
    options.path_limit = 0;
  else
    options.update = StressUpdate::SUBSTEPPED;
  return options;
}

} // namespace

template <int Dim> void add_step_error(const Workpiece<Dim>& workpiece, StepErrorState& state) {
  state.last = 0;
  const MaterialLaw<Dim>& law = workpiece.law();
  const int variable = law.internal_variables().find("plastic_strain_eq");
  if (workpiece.user_defined() || variable < 0 || workpiece.options().update == StressUpdate::FORWARD_EULER)
    return;
  const int ep = law.internal_variables().offset(variable);
  const UpdateOptions options = other_way(workpiece.options());
  std::vector<double> internal(static_cast<std::size_t>(law.internal_variables().size()));
  double difference = 0, increment = 0, strain = 0;
  for (int p = 0; p < workpiece.discretization().num_points(); ++p) {
    if (workpiece.state().plastic[p] == 0) continue;
    const PointStep<Dim> step = workpiece.point_step(p);
    if (!(step.ratio > 0)) continue; // no step before: no curvature is known
    PointTrial trial;
    PointUpdate<Dim> other;
    other.internal = internal.data();
    if (law.update({step.old, step.F, step.ratio, 0, options}, trial, other).status != UpdateStatus::OK)
      continue;
    const double weight = workpiece.discretization().weight[p],
                 found = point_state(workpiece.state(), p).internal[ep];
    const double grown = found - step.old.internal[ep];
    difference += weight * (internal[ep] - found) * (internal[ep] - found);
    increment += weight * grown * grown;
    strain += weight * grown;
  }
  if (!(increment > 0)) return;
  state.last = std::sqrt(difference / increment);
  state.weighted += state.last * strain;
  state.strain += strain;
}

template void add_step_error<2>(const Workpiece<2>&, StepErrorState&);
template void add_step_error<3>(const Workpiece<3>&, StepErrorState&);

} // namespace burnish

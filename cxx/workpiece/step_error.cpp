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

// A law of the script whose increments of plastic_strain_eq are, in the mean, so near to those of the material's single return is
// that return: its error is known.
constexpr double SAME_LAW = 0.1;

// Increment of plastic_strain_eq in a step; NaN where the law does not follow.
template <int Dim>
double plastic_increment(const MaterialLaw<Dim>& law, const PointStep<Dim>& step, int place,
                         const UpdateOptions& options) {
  std::vector<double> internal(static_cast<std::size_t>(law.internal_variables().size()));
  PointTrial trial;
  PointUpdate<Dim> now;
  now.internal = internal.data();
  if (law.update({step.old, step.F, step.ratio, 0, options}, trial, now).status != UpdateStatus::OK)
    return std::nan("");
  return internal[place] - step.old.internal[place];
}

} // namespace

template <int Dim> void add_step_error(const Workpiece<Dim>& workpiece, StepErrorState& state) {
  state.last = 0;
  const MaterialLaw<Dim>& law = workpiece.law();
  const int variable = law.internal_variables().find("plastic_strain_eq");
  UpdateOptions own = workpiece.options();
  if (variable < 0 || !law.has_moduli() || own.update == StressUpdate::FORWARD_EULER) return;
  const bool user = workpiece.user_defined();
  if (user) own.update = StressUpdate::SINGLE;
  const int ep = law.internal_variables().offset(variable);
  double difference = 0, off = 0, increment = 0, strain = 0;
  for (int p = 0; p < workpiece.discretization().num_points(); ++p) {
    if (workpiece.state().plastic[p] == 0) continue;
    const PointStep<Dim> step = workpiece.point_step(p);
    if (!(step.ratio > 0)) continue; // no step before: no curvature is known
    const double grown = point_state(workpiece.state(), p).internal[ep] - step.old.internal[ep],
                 single = user ? plastic_increment(law, step, ep, own) : grown,
                 other = plastic_increment(law, step, ep, other_way(own));
    if (!std::isfinite(single) || !std::isfinite(other)) continue;
    const double weight = workpiece.discretization().weight[p];
    difference += weight * (other - single) * (other - single);
    off += weight * (single - grown) * (single - grown);
    increment += weight * grown * grown;
    strain += weight * grown;
  }
  if (!(increment > 0) || off > SAME_LAW * SAME_LAW * increment) return;
  state.last = std::sqrt(difference / increment);
  state.weighted += state.last * strain;
  state.strain += strain;
}

template void add_step_error<2>(const Workpiece<2>&, StepErrorState&);
template void add_step_error<3>(const Workpiece<3>&, StepErrorState&);

} // namespace burnish

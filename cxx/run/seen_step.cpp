#include "run/seen_step.hpp"
#include "diagnosis/words.hpp"

namespace burnish {

template <int Dim>
AcceptedStep<Dim> accepted_step(const ContactRun<Dim>& run, const Workpiece<Dim>* workpiece) {
  const ContactRunState<Dim>& state = run.accepted();
  AcceptedStep<Dim> step{run.setup(), state.contact, state.u, state.R, state.generalized_force, workpiece};
  const Hold<Dim>& hold = run.loads().hold;
  if (hold.state().factor > 0) step.hold.force = hold.force(state.u, hold.state().factor);
  step.jumped = state.jumps.dissipated;
  step.drives = std::abs(state.jumps.work);
  step.hold.share = hold.state().share;
  step.hold.until = hold.state().until;
  step.allowed.load = run.iteration().balance().memory().scale;
  step.allowed.relative = run.iteration().options().tolerance;
  step.allowed.rounding = state.load.rounding;
  step.allowed.offset = run.iteration().options().offset_tolerance * run.setup().body().spacing;
  step.t = run.step().end();
  step.dt = run.step().dt;
  step.prescribed = &state.prescribed;
  step.window = state.factor.window.size();
  return step;
}

template <int Dim>
std::string reason(const ContactRun<Dim>& run, const Diagnosis<Dim>& diagnosis,
                   const Workpiece<Dim>* workpiece, const std::string& refusal) {
  const ContactRunState<Dim>& state = run.accepted();
  const Failure& found = run.iteration().failure();
  const FailedStep<Dim> step{run.setup(),
                             state.contact,
                             state.u,
                             state.generalized_force,
                             state.prescribed,
                             run.step().prescribed,
                             found,
                             workpiece,
                             run.step().t,
                             run.step().dt,
                             state.history.dt,
                             state.largest_dt,
                             run.loads().hold.acts(run.step().end())};
  return words(found, diagnosis.explain(step), refusal, run.setup().model());
}

template AcceptedStep<2> accepted_step<2>(const ContactRun<2>&, const Workpiece<2>*);
template AcceptedStep<3> accepted_step<3>(const ContactRun<3>&, const Workpiece<3>*);
template std::string reason<2>(const ContactRun<2>&, const Diagnosis<2>&, const Workpiece<2>*,
                               const std::string&);
template std::string reason<3>(const ContactRun<3>&, const Diagnosis<3>&, const Workpiece<3>*,
                               const std::string&);

} // namespace burnish

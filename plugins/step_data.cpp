// What a script reads of a stepcontrol, and the verbs of a user-defined loop.
//   S.count(name)   counts of the run | -
//     name      "steps", "rejected", "pieces", "pileups", "atonce", "blind"
//     ! , expected steps, rejected, pieces, pileups, atonce or blind
//   S.excess    article: largest q/sigma_y - 1 | -
//   S.halted    a self-check ended the run
//   S.measures   names of the numbers that the self-checks measured, "a,b,"
//   S.measured(name)   the worst of one | its own
//     name      one of S.measures
//     ! no check has measured
//   S.purerates   the present piece is one of scheme article
//   S.crawls    steps are far below dtmax after a failure
//   S.lastrejection   why the last step was rejected
//   S.rejecteddt   its length, 0: none was | time
//   S.error     estimated relative error that the length of the steps makes in the plastic strain increments, -1: none | -
//   S.nodesrolled   node spacings that the contact rolls in a step, mean; 0: it does not roll | -
//   S.t         start of the step to come: end of the accepted one | time
//   S.dt        length of the step to come, or of the present one | time
//   S.tend      end of the program | time
//   S.target    end of the present step, for program | time
//   S.piece     length of the present piece of the step | time
//   S.iteration   number of the iteration in it, from 0 | -
//   S.finished   the end is reached
//   S.atoutput   S.t is one of output= or the end
//   S.atfloor   the run ended since no step is short enough
//   S.reason    why the run ended early
//   S.propose(width, speed)   a user-defined loop: length of the next step | time
//     width     of the contact, 0: unknown | length
//     speed     of the contact along the body, 0: unknown | length/time
//     ! a run is under way; this verb is for a loop of the script's own
//   S.accepted()   the step was taken
//     ! there is no step yet, call propose first
//   S.rejected()   it was not: S.dt is shorter now; false: below the floor
//   S.cut(fraction)   shortens the present step; returns its length | time
//     fraction   part that is kept | - | | 0 < fraction <= 1
#include "base/error.hpp"
#include "named.hpp"
#include "step_control.hpp"

namespace burnish {
namespace {

using S = StepControlHandle;

bool halted(S* const& h) { return h->get().stepper && h->get().stepper->halted(); }
string* measures(Stack stack, S* const& h) {
  return guarded([&] {
    std::string names;
    if (h->get().stepper)
      visit(*h->get().contact, [&](auto& contact) {
        for (const auto& [name, value] : contact.diagnosis.findings().measured()) names += name + ",";
      });
    return new_string(stack, names);
  });
}
struct MeasuredTag {};
double measured(const Method<S, MeasuredTag>& m, string* const& name) {
  return guarded([&] {
    m->get().running("stepcontrol.measured");
    return visit(*m->get().contact, [&](auto& contact) {
      const auto& measured = contact.diagnosis.findings().measured();
      const auto found = measured.find(*name);
      if (found == measured.end())
        fail("stepcontrol.measured", "no check has measured \"" + *name + "\", see S.measures");
      return found->second;
    });
  });
}

struct CountTag {};
long count(const Method<S, CountTag>& m, string* const& name) {
  return guarded([&] {
    const StepperCounts counts = m->get().stepper ? m->get().stepper->counts() : StepperCounts{};
    if (*name == "steps") return counts.steps;
    if (*name == "rejected") return counts.rejected;
    if (*name == "pieces") return counts.scheme.pieces;
    if (*name == "pileups") return counts.scheme.pileups;
    if (*name == "atonce") return counts.scheme.at_once;
    if (*name == "blind") return counts.scheme.blind;
    fail("stepcontrol.count",
         "unknown name \"" + *name + "\", expected steps, rejected, pieces, pileups, atonce or blind");
  });
}

template <double (*read)(const ControlObject&)> double number(S* const& h) {
  return guarded([&] { return read(h->get()); });
}
double target(const ControlObject& o) { return o.running("stepcontrol.target").target(); }
double piece(const ControlObject& o) { return o.running("stepcontrol.piece").dt(); }
double excess(const ControlObject& o) { return o.running("stepcontrol.excess").counts().scheme.excess; }
double rejected_dt(const ControlObject& o) { return o.stepper ? o.stepper->rejected_dt() : 0; }
double error_of(const ControlObject& o) { return o.stepper ? o.stepper->error() : -1; }
double nodes_per_step(const ControlObject& o) { return o.stepper ? o.stepper->counts().nodes_per_step() : 0; }
double time_of(const ControlObject& o) { return o.now().time(); }
double dt_of(const ControlObject& o) { return o.now().dt(); }
double end_of(const ControlObject& o) { return o.now().options().t_end; }
long iteration(S* const& h) {
  return guarded([&] { return static_cast<long>(h->get().running("stepcontrol.iteration").iteration()); });
}
bool finished(S* const& h) { return h->get().now().finished(); }
bool at_output(S* const& h) { return h->get().now().at_output(); }
bool at_floor(S* const& h) { return h->get().stepper && h->get().stepper->at_floor(); }
bool pure_rates(S* const& h) {
  return guarded([&] { return h->get().running("stepcontrol.purerates").stepping() == Stepping::RATES; });
}
bool crawls(S* const& h) { return h->get().now().crawls(); }
string* reason(Stack stack, S* const& h) {
  return new_string(stack, h->get().stepper ? h->get().stepper->reason() : "");
}
string* last_rejection(Stack stack, S* const& h) {
  return new_string(stack, h->get().stepper ? h->get().stepper->last_rejection() : "");
}

// --- a user-defined loop
struct ProposeTag {};
struct AcceptedTag {};
struct RejectedTag {};
struct CutTag {};
void require_idle(S* handle, const char* where) {
  if (handle->get().under_way())
    fail(where, "a run is under way; this verb is for a loop of the script's own");
}
StepControl& proposed(S* handle, const char* where) {
  require_idle(handle, where);
  StepControl& control = *handle->get().control;
  if (control.dt() <= 0) fail(where, "there is no step yet, call propose first");
  return control;
}
double propose(const Method<S, ProposeTag>& m, const double& width, const double& speed) {
  return guarded([&] {
    require_idle(m.object, "stepcontrol.propose");
    return m->get().control->propose(width, speed);
  });
}
bool accepted(const Method<S, AcceptedTag>& m) {
  return guarded([&] { return proposed(m.object, "stepcontrol.accepted").accepted(), true; });
}
bool rejected(const Method<S, RejectedTag>& m) {
  return guarded([&] { return proposed(m.object, "stepcontrol.rejected").rejected(); });
}
double cut(const Method<S, CutTag>& m, const double& f) {
  return guarded([&] {
    require(f > 0 && f <= 1, "stepcontrol.cut", "fraction", f, "0 < fraction <= 1");
    proposed(m.object, "stepcontrol.cut").cut(f);
    return m->get().control->dt();
  });
}

void register_own_loop() {
  add_method<S, ProposeTag>(
      "propose", [] { return new OneOperator3_<double, Method<S, ProposeTag>, double, double>(propose); });
  add_method<S, AcceptedTag>("accepted",
                             [] { return new OneOperator1_<bool, Method<S, AcceptedTag>>(accepted); });
  add_method<S, RejectedTag>("rejected",
                             [] { return new OneOperator1_<bool, Method<S, RejectedTag>>(rejected); });
  add_method<S, CutTag>("cut", [] { return new OneOperator2_<double, Method<S, CutTag>, double>(cut); });
}

void register_values() {
  Add<S*>("t", ".", new OneOperator1_<double, S*>(number<time_of>));
  Add<S*>("dt", ".", new OneOperator1_<double, S*>(number<dt_of>));
  Add<S*>("tend", ".", new OneOperator1_<double, S*>(number<end_of>));
  Add<S*>("target", ".", new OneOperator1_<double, S*>(number<target>));
  Add<S*>("piece", ".", new OneOperator1_<double, S*>(number<piece>));
  Add<S*>("excess", ".", new OneOperator1_<double, S*>(number<excess>));
  Add<S*>("rejecteddt", ".", new OneOperator1_<double, S*>(number<rejected_dt>));
  Add<S*>("error", ".", new OneOperator1_<double, S*>(number<error_of>));
  Add<S*>("nodesrolled", ".", new OneOperator1_<double, S*>(number<nodes_per_step>));
  Add<S*>("iteration", ".", new OneOperator1_<long, S*>(iteration));
  Add<S*>("finished", ".", new OneOperator1_<bool, S*>(finished));
  Add<S*>("atoutput", ".", new OneOperator1_<bool, S*>(at_output));
  Add<S*>("atfloor", ".", new OneOperator1_<bool, S*>(at_floor));
  Add<S*>("purerates", ".", new OneOperator1_<bool, S*>(pure_rates));
  Add<S*>("halted", ".", new OneOperator1_<bool, S*>(halted));
  Add<S*>("measures", ".", new OneOperator1s_<string*, S*>(measures));
  Add<S*>("crawls", ".", new OneOperator1_<bool, S*>(crawls));
  Add<S*>("reason", ".", new OneOperator1s_<string*, S*>(reason));
  Add<S*>("lastrejection", ".", new OneOperator1s_<string*, S*>(last_rejection));
}

} // namespace

void register_step_data() {
  add_method<S, CountTag>("count",
                          [] { return new OneOperator2_<long, Method<S, CountTag>, string*>(count); });
  add_method<S, MeasuredTag>(
      "measured", [] { return new OneOperator2_<double, Method<S, MeasuredTag>, string*>(measured); });
  register_values();
  register_own_loop();
}

} // namespace burnish

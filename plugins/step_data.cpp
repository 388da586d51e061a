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

using H = StepControlHandle;

bool halted(H* const& h) { return h->get().stepper && h->get().stepper->halted(); }
string* measures(Stack stack, H* const& h) {
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
double measured(const Method<H, MeasuredTag>& m, string* const& name) {
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
long count(const Method<H, CountTag>& m, string* const& name) {
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

template <double (*read)(const ControlObject&)> double number(H* const& h) {
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
long iteration(H* const& h) {
  return guarded([&] { return static_cast<long>(h->get().running("stepcontrol.iteration").iteration()); });
}
bool finished(H* const& h) { return h->get().now().finished(); }
bool at_output(H* const& h) { return h->get().now().at_output(); }
bool at_floor(H* const& h) { return h->get().stepper && h->get().stepper->at_floor(); }
bool pure_rates(H* const& h) {
  return guarded([&] { return h->get().running("stepcontrol.purerates").stepping() == Stepping::RATES; });
}
bool crawls(H* const& h) { return h->get().now().crawls(); }
string* reason(Stack stack, H* const& h) {
  return new_string(stack, h->get().stepper ? h->get().stepper->reason() : "");
}
string* last_rejection(Stack stack, H* const& h) {
  return new_string(stack, h->get().stepper ? h->get().stepper->last_rejection() : "");
}

// --- a user-defined loop
struct ProposeTag {};
struct AcceptedTag {};
struct RejectedTag {};
struct CutTag {};
void require_idle(H* handle, const char* where) {
  if (handle->get().under_way())
    fail(where, "a run is under way; this verb is for a loop of the script's own");
}
StepControl& proposed(H* handle, const char* where) {
  require_idle(handle, where);
  StepControl& control = *handle->get().control;
  if (control.dt() <= 0) fail(where, "there is no step yet, call propose first");
  return control;
}
double propose(const Method<H, ProposeTag>& m, const double& width, const double& speed) {
  return guarded([&] {
    require_idle(m.object, "stepcontrol.propose");
    return m->get().control->propose(width, speed);
  });
}
bool accepted(const Method<H, AcceptedTag>& m) {
  return guarded([&] { return proposed(m.object, "stepcontrol.accepted").accepted(), true; });
}
bool rejected(const Method<H, RejectedTag>& m) {
  return guarded([&] { return proposed(m.object, "stepcontrol.rejected").rejected(); });
}
double cut(const Method<H, CutTag>& m, const double& f) {
  return guarded([&] {
    require(f > 0 && f <= 1, "stepcontrol.cut", "fraction", f, "0 < fraction <= 1");
    proposed(m.object, "stepcontrol.cut").cut(f);
    return m->get().control->dt();
  });
}

void register_own_loop() {
  add_method<H, ProposeTag>(
      "propose", [] { return new OneOperator3_<double, Method<H, ProposeTag>, double, double>(propose); });
  add_method<H, AcceptedTag>("accepted",
                             [] { return new OneOperator1_<bool, Method<H, AcceptedTag>>(accepted); });
  add_method<H, RejectedTag>("rejected",
                             [] { return new OneOperator1_<bool, Method<H, RejectedTag>>(rejected); });
  add_method<H, CutTag>("cut", [] { return new OneOperator2_<double, Method<H, CutTag>, double>(cut); });
}

void register_values() {
  Add<H*>("t", ".", new OneOperator1_<double, H*>(number<time_of>));
  Add<H*>("dt", ".", new OneOperator1_<double, H*>(number<dt_of>));
  Add<H*>("tend", ".", new OneOperator1_<double, H*>(number<end_of>));
  Add<H*>("target", ".", new OneOperator1_<double, H*>(number<target>));
  Add<H*>("piece", ".", new OneOperator1_<double, H*>(number<piece>));
  Add<H*>("excess", ".", new OneOperator1_<double, H*>(number<excess>));
  Add<H*>("rejecteddt", ".", new OneOperator1_<double, H*>(number<rejected_dt>));
  Add<H*>("error", ".", new OneOperator1_<double, H*>(number<error_of>));
  Add<H*>("nodesrolled", ".", new OneOperator1_<double, H*>(number<nodes_per_step>));
  Add<H*>("iteration", ".", new OneOperator1_<long, H*>(iteration));
  Add<H*>("finished", ".", new OneOperator1_<bool, H*>(finished));
  Add<H*>("atoutput", ".", new OneOperator1_<bool, H*>(at_output));
  Add<H*>("atfloor", ".", new OneOperator1_<bool, H*>(at_floor));
  Add<H*>("purerates", ".", new OneOperator1_<bool, H*>(pure_rates));
  Add<H*>("halted", ".", new OneOperator1_<bool, H*>(halted));
  Add<H*>("measures", ".", new OneOperator1s_<string*, H*>(measures));
  Add<H*>("crawls", ".", new OneOperator1_<bool, H*>(crawls));
  Add<H*>("reason", ".", new OneOperator1s_<string*, H*>(reason));
  Add<H*>("lastrejection", ".", new OneOperator1s_<string*, H*>(last_rejection));
}

} // namespace

void register_step_data() {
  add_method<H, CountTag>("count",
                          [] { return new OneOperator2_<long, Method<H, CountTag>, string*>(count); });
  add_method<H, MeasuredTag>(
      "measured", [] { return new OneOperator2_<double, Method<H, MeasuredTag>, string*>(measured); });
  register_values();
  register_own_loop();
}

} // namespace burnish

// Script type `stepcontrol`: the length of the steps, and the loop over them turned inside out (edp/run/rcRun.idp).
//   > stepcontrol S(1., dtmax=0.05);
//   > rcRun(C, M, u[], S, program, record)
//   stepcontrol(tend)   the program runs from t = 0 to tend
//     tend      end of the program | time | | > 0
//     dtmax=    largest step | time | tend/100 | finite > 0
//     dtmin=    smallest step: a run that needs a shorter one ends | time | 1e-7 tend | 0 < dtmin <= dtmax
//     dtfirst=   first step: the whole program where nothing flows | time | a quarter of dtmax | dtmin <= dtfirst <= dtmax
//     stepsperwidth=   steps at least while the contact rolls its width, 0: no such limit | - | 14 | >= 0
//     accuracy=   chooses the steps by the relative error of the plastic strain increments, S.error | - | fixed by dtmax and
//       the contact width | finite > 0
//     output=   instants that a step ends at, real[int] | time | none
//     scheme=   way through a step | | "implicit" | "implicit", "event", "article"
//     elementevents=   yield and unloading of points: "log": located in every accepted step and logged; "cut": the step is
//       cut at them and at user-defined events | | "none", with scheme article "cut" | "none", "log", "cut", "default"
//     eventtolerance=   events this close to the earliest one are taken with it, fraction of the step | - | 1e-3 | finite > 0
//     eventnoise=   stress that the residual's tolerance leaves, over the yield stress (event steps) | - | 1e-4 | finite > 0
//     nodesperstep=   a rolling step is at least this many node spacings long | - | 1 | finite > 0
//     widthsteps=   as stepsperwidth, for narrow contacts: the contact counts as that many spacings wide | - | 14 | finite > 0
//     fallback=   of older scripts: without effect, implicit steps do without it now | - | 0 | 0
//     maxpieces=   article: pieces of a step between events | - | 100 | 1 to 999999
//     maxretries=   article: changes of state at one instant | - | 4 | 1 to 999999
//     ! , expected implicit, event or article
//     ! , expected none, log, cut or default
//   S.start(C, M)   a run begins
//     C         contact
//     M         material on the same mesh
//   S.next(u, R)   what has to be done next, a task such as rcForces | -
//     u         displacement of the run: only rcSolve may change it | length
//     R         nodal forces | force
//     ! no run has been started, call start first
//     ! : the run's displacement was changed by
//   rcProgram, rcAcceptLaw, rcRevertLaw, rcForces, rcTangent, rcSolve, rcRecord, rcFinished, rcStopped   tasks of S.next: set
//       every coordinate for S.target; of a law of the script: the end of the step becomes its start, back to that; M.update(u, S.piece, S.iteration) and nodal forces into R; C.factorize(M, u); condense, solve, expand; a
//       step has been accepted; the end is reached; the run has ended early, S.reason tells why
//   S.condensed(on)   every iteration is an rcSolve: the condensed matrix for a solver of the script
//     on        true or false | | false
//   S.scheme(name)   another scheme from the next step on
//     name      "implicit", "event", "article"
//   S.accuracy(value)   as accuracy=, before S.start
//     value     relative error | - | | finite > 0
//     ! the run has been started, state an accuracy before
//   S.refuse(text)   the task cannot be done: the step is tried shorter
//     text      why
//   S.stop(text)   ends the run at the accepted state
//     text      why
//   S.checks(on)   false: no self-checks (contact_findings.cpp), no report
//     on        true or false | | true
#include "step_control.hpp"
#include "base/error.hpp"
#include "named.hpp"
#include <algorithm>

namespace burnish {
namespace {

using H = StepControlHandle;

Scheme scheme_of(const std::string& name) {
  if (name == "implicit") return Scheme::IMPLICIT;
  if (name == "event") return Scheme::EVENT;
  if (name == "article") return Scheme::ARTICLE;
  fail("stepcontrol", "unknown scheme \"" + name + "\", expected implicit, event or article");
}
ElementEvents elements_of(const std::string& name, Scheme scheme) {
  if (name == "default") return scheme == Scheme::ARTICLE ? ElementEvents::CUT : ElementEvents::NONE;
  if (name == "none") return ElementEvents::NONE;
  if (name == "log") return ElementEvents::LOG;
  if (name == "cut") return ElementEvents::CUT;
  fail("stepcontrol", "unknown elementevents \"" + name + "\", expected none, log, cut or default");
}

// Errors name the options as scripts do: dt_min is dtmin there.
std::unique_ptr<StepControl> control_of(const StepControlOptions& options) {
  try {
    return called("stepcontrol", [&] { return std::make_unique<StepControl>(0, options); });
  } catch (const std::invalid_argument& error) {
    std::string text = error.what();
    text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
    throw std::invalid_argument(text);
  }
}

struct MakeStepControl {
  static const int n = 15;
  static basicAC_F0::name_and_type names[n];
  static double positive(const Named& a, const char* name, double otherwise) {
    if (!a.has(name)) return otherwise;
    const double value = a.real(name, 0);
    require(std::isfinite(value) && value > 0, "stepcontrol", name, value, "a finite number > 0");
    return value;
  }
  static int count(const Named& a, const char* name, int otherwise) {
    const long value = a.integer(name, otherwise);
    require(value > 0 && value < 1000000, "stepcontrol", name, value, "1 to 999999");
    return static_cast<int>(value);
  }
  static H* call(const Named& a, H* handle, double t_end) {
    handle->init();
    StepControlOptions control;
    control.t_end = t_end;
    control.dt_max = positive(a, "dtmax", control.dt_max);
    control.dt_min = positive(a, "dtmin", control.dt_min);
    control.dt_first = positive(a, "dtfirst", control.dt_first);
    control.steps_per_width = a.real("stepsperwidth", control.steps_per_width);
    control.accuracy = positive(a, "accuracy", control.accuracy);
    if (a.has("output")) {
      const Eigen::VectorXd times = to_vector(a.array("output"), "stepcontrol", "output");
      control.output_times.assign(times.data(), times.data() + times.size());
    }
    auto object = std::make_shared<ControlObject>();
    StepperOptions& options = object->options;
    options.scheme = scheme_of(a.text("scheme", "implicit"));
    options.events.elements = elements_of(a.text("elementevents", "default"), options.scheme);
    options.events.event_tolerance = positive(a, "eventtolerance", options.events.event_tolerance);
    options.events.event_noise = positive(a, "eventnoise", options.events.event_noise);
    options.nodes_per_step = positive(a, "nodesperstep", options.nodes_per_step);
    options.width_steps = positive(a, "widthsteps", options.width_steps);
    require(a.integer("fallback", 0) == 0, "stepcontrol", "fallback", a.integer("fallback", 0),
            "0: implicit steps do without it now");
    options.events.max_pieces = count(a, "maxpieces", options.events.max_pieces);
    options.events.max_retries = count(a, "maxretries", options.events.max_retries);
    object->control = control_of(control);
    handle->set(std::move(object));
    return handle;
  }
};
basicAC_F0::name_and_type MakeStepControl::names[] = {
    {"accuracy", &typeid(double)},       {"dtmax", &typeid(double)},          {"dtmin", &typeid(double)},
    {"stepsperwidth", &typeid(double)},  {"output", &typeid(KN_<double>)},    {"scheme", &typeid(string*)},
    {"elementevents", &typeid(string*)}, {"eventtolerance", &typeid(double)}, {"eventnoise", &typeid(double)},
    {"nodesperstep", &typeid(double)},   {"widthsteps", &typeid(double)},     {"maxpieces", &typeid(long)},
    {"maxretries", &typeid(long)},       {"fallback", &typeid(long)},         {"dtfirst", &typeid(double)}};

// Before start: the control is made anew.
struct AccuracyTag {};
bool set_accuracy(const Method<H, AccuracyTag>& m, const double& accuracy) {
  return guarded([&] {
    ControlObject& object = m->get();
    if (object.stepper) fail("stepcontrol.accuracy", "the run has been started, state an accuracy before");
    require(std::isfinite(accuracy) && accuracy > 0, "stepcontrol.accuracy", "accuracy", accuracy,
            "a finite number > 0");
    StepControlOptions options = object.control->options();
    options.accuracy = accuracy;
    object.control = std::make_unique<StepControl>(0, options);
    return true;
  });
}

struct StartTag {};
bool start(const Method<H, StartTag>& m, ContactHandle* const& contact, MaterialHandle* const& material) {
  return guarded([&] {
    ControlObject& object = m->get();
    object.stepper.reset();
    object.task = Task::STOPPED;
    object.stopping = false;
    if (object.contact) object.contact->under_way = false;
    contact->get().require_same_mesh(material->get(), "stepcontrol.start");
    object.statements.clear();
    object.statements_at = -1;
    object.contact = contact->share();
    object.material = material->share();
    object.stepper = std::make_unique<Stepper<2>>(object.contact->run(), *object.material->body,
                                                  object.contact->diagnosis, *object.control, object.options);
    object.contact->diagnosis.set_checks(object.checks);
    return true;
  });
}

// Only rcSolve moves u. What a script has written there is taken back, so that the run can end at its accepted state.
void require_untouched(const ControlObject& object, const Eigen::VectorXd& now, const KN_<double>& u) {
  if (!object.under_way() || object.stopping || object.task == Task::SOLVE) return;
  for (Eigen::Index d = 0; d < now.size(); ++d) {
    if (now[d] == object.u[d]) continue;
    to_array(object.u, u, "stepcontrol.next");
    const bool record = object.task == Task::RECORD;
    std::ostringstream text;
    text << "u[" << d << "] = " << now[d] << ", expected " << object.u[d]
         << ": the run's displacement was changed by "
         << (record                         ? "record"
             : object.task == Task::PROGRAM ? "program"
                                            : "the forces or the tangent");
    fail("stepcontrol.next", text.str());
  }
}

struct NextTag {};
long next(Stack, const Method<H, NextTag>& m, const KN_<double>& u, const KN_<double>& R) {
  return guarded([&] {
    ControlObject& object = m->get();
    Stepper<2>& stepper = object.running("stepcontrol.next");
    const CpuTimer timer(object.contact->event_seconds);
    const long n = object.contact->setup->mesh().num_dofs();
    Eigen::VectorXd v = to_dofs(u, n, "stepcontrol.next", "u"),
                    force = to_dofs(R, n, "stepcontrol.next", "R");
    require_untouched(object, v, u);
    const double checks = object.contact->diagnosis.seconds(), linear = object.contact->linear_seconds();
    object.material->changed();
    const Task task = called("contact.begin", [&] { return stepper.next(v, force); });
    const double checked = object.contact->diagnosis.seconds() - checks;
    object.contact->event_seconds -= checked + object.contact->linear_seconds() - linear;
    to_array(v, u, "stepcontrol.next");
    object.task = task;
    object.contact->under_way = object.under_way();
    object.u = std::move(v);
    to_array(force, R, "stepcontrol.next");
    *object.control = stepper.control();
    return static_cast<long>(task);
  });
}
struct RefuseTag {};
struct StopTag {};
bool refuse(const Method<H, RefuseTag>& m, string* const& reason) {
  return guarded([&] { return m->get().running("stepcontrol.refuse").refuse(*reason), true; });
}
bool stop(const Method<H, StopTag>& m, string* const& reason) {
  return guarded([&] {
    m->get().running("stepcontrol.stop").stop(*reason);
    m->get().stopping = true;
    return true;
  });
}

struct SchemeTag {};
bool set_scheme(const Method<H, SchemeTag>& m, string* const& name) {
  return guarded([&] {
    ControlObject& object = m->get();
    object.options.scheme = scheme_of(*name);
    if (object.stepper) object.stepper->set_scheme(object.options.scheme);
    return true;
  });
}

struct CondensedTag {};
bool set_condensed(const Method<H, CondensedTag>& m, const bool& condensed) {
  return guarded([&] {
    ControlObject& object = m->get();
    object.options.condensed = condensed;
    if (object.stepper) object.stepper->set_condensed(condensed);
    return condensed;
  });
}

struct ChecksTag {};
bool set_checks(const Method<H, ChecksTag>& m, const bool& on) {
  return guarded([&] {
    ControlObject& object = m->get();
    object.checks = on;
    if (object.contact) object.contact->diagnosis.set_checks(on);
    return on;
  });
}
} // namespace

void register_step_control() {
  Dcl_Type<H*>(InitP<H>, Destroy<H>);
  zzzfff->Add("stepcontrol", atype<H*>());
  TheOperators->Add("<-", new NamedOperator<MakeStepControl, H*, H*, double>);
  add_method<H, StartTag>("start", [] {
    return new OneOperator3_<bool, Method<H, StartTag>, ContactHandle*, MaterialHandle*>(start);
  });
  add_method<H, NextTag>(
      "next", [] { return new OneOperator3s_<long, Method<H, NextTag>, KN_<double>, KN_<double>>(next); });
  add_method<H, RefuseTag>("refuse",
                           [] { return new OneOperator2_<bool, Method<H, RefuseTag>, string*>(refuse); });
  add_method<H, SchemeTag>("scheme",
                           [] { return new OneOperator2_<bool, Method<H, SchemeTag>, string*>(set_scheme); });
  add_method<H, AccuracyTag>(
      "accuracy", [] { return new OneOperator2_<bool, Method<H, AccuracyTag>, double>(set_accuracy); });
  add_method<H, CondensedTag>(
      "condensed", [] { return new OneOperator2_<bool, Method<H, CondensedTag>, bool>(set_condensed); });
  add_method<H, StopTag>("stop", [] { return new OneOperator2_<bool, Method<H, StopTag>, string*>(stop); });
  add_method<H, ChecksTag>("checks",
                           [] { return new OneOperator2_<bool, Method<H, ChecksTag>, bool>(set_checks); });
  register_step_data();
  register_scene_report();
  long number = 0;
  for (const char* name : {"rcProgram", "rcAcceptLaw", "rcRevertLaw", "rcForces", "rcTangent", "rcSolve",
                           "rcRecord", "rcFinished", "rcStopped"})
    Global.New(name, CConstant<long>(number++));
}

} // namespace burnish

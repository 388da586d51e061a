// Script type `stepcontrol`: the length of the steps, and the loop over them turned inside out (edp/run/rcRun.idp).
//   > stepcontrol S(1., dtmax=0.05);
//   > rcRun(C, M, u[], S, program, record)
//   stepcontrol(tend)   the program runs from t = 0 to tend
//     tend      end of the program | time | | > 0
//     output=   instants that a step ends at, real[int] | time | none
//     fallback=   of older scripts: without effect, implicit steps do without it now | - | 0 | 0
//   S.start(C, M), S.start(C)   a run begins; without a material nothing is known of the stress
//     C         contact
//     M         material on the same mesh
//   S.next(u, R)   what has to be done next, a task such as rcForces | -
//     u         displacement of the run: only rcSolve may change it, and C.expand in rcTangent | length
//     R         nodal forces | force
//     ! no run has been started, call start first
//     ! : the run's displacement was changed by
//   rcProgram, rcAcceptLaw, rcRevertLaw, rcForces, rcTangent, rcSolve, rcRecord, rcFinished, rcStopped   tasks of S.next: set
//       every coordinate for S.target; of a law of the script: the end of the step becomes its start, back to that; M.update(u, S.piece, S.iteration) and nodal forces into R; C.factorize(M, u), or C.condense, a
//       solution, C.expand; pure rates: the same; a step has been accepted; the end is reached; the run has ended early, S.reason tells why
//   S.scheme(name)   another scheme from the next step on
//     name      "implicit", "event", "article"
//   S.refuse(text)   the task cannot be done: the step is tried shorter
//     text      why
//   S.stop(text)   ends the run at the accepted state
//     text      why
//   S.checks(on)   false: no self-checks (contact_findings.cpp), no report
//     on        true or false | | true
#include "step_control.hpp"
#include "base/error.hpp"
#include "checkpoint/identity.hpp"
#include "material/user_law.hpp"
#include "mesh/mesh_match.hpp"
#include "named.hpp"
#include "settings.hpp"
#include <algorithm>

namespace burnish {
namespace {

using S = StepControlHandle;

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
  static std::vector<basicAC_F0::name_and_type> list;
  static const int n;
  static basicAC_F0::name_and_type* const names;
  static S* call(const Named& a, S* handle, double t_end) {
    handle->init();
    Settings settings = settings_of(a, "stepcontrol", "stepcontrol");
    settings.control.t_end = t_end;
    if (a.has("output")) {
      const Eigen::VectorXd times = to_vector(a.array("output"), "stepcontrol", "output");
      settings.control.output_times.assign(times.data(), times.data() + times.size());
    }
    require(a.integer("fallback", 0) == 0, "stepcontrol", "fallback", a.integer("fallback", 0),
            "0: implicit steps do without it now");
    auto object = std::make_shared<ControlObject>();
    object->options = settings.stepper;
    object->control = control_of(settings.control);
    handle->set(std::move(object));
    return handle;
  }
};
std::vector<basicAC_F0::name_and_type> MakeStepControl::list =
    setting_names("stepcontrol", {{"output", &typeid(KN_<double>)}, {"fallback", &typeid(long)}});
const int MakeStepControl::n = static_cast<int>(list.size());
basicAC_F0::name_and_type* const MakeStepControl::names = list.data();

struct StartTag {};
void start_run(const std::shared_ptr<ControlObject>& started, ContactHandle* contact,
               std::shared_ptr<MaterialObject> material, bool forms_only) {
  ControlObject& object = *started;
  object.stepper.reset();
  object.task = Task::STOPPED;
  object.stopping = object.checkpointed = object.remeshed = false;
  if (object.contact) object.contact->under_way = false;
  visit(contact->get(), [&](auto& run) {
    constexpr int Dim = dim_of<decltype(run)>;
    auto& body = run.with_material(*material, "stepcontrol.start");
    object.statements.clear();
    object.statements_at = -1;
    object.contact = contact->share();
    object.material = std::move(material);
    if (!forms_only) run.material = object.material;
    object.options.forms_only = forms_only;
    begin_stepper<Dim>(started, run, body);
    object.scene = identity_of(run.run(), *body.body, object.now().options(), object.options.forms_only);
  });
}
bool start(const Method<S, StartTag>& m, ContactHandle* const& contact, MaterialHandle* const& material) {
  return guarded([&] { return start_run(m.object->share(), contact, material->share(), false), true; });
}
template <int Dim> std::shared_ptr<MaterialObject> unknown_material(const ContactOf<Dim>& contact) {
  auto material = std::make_shared<MaterialOf<Dim>>();
  auto workpiece =
      std::make_unique<Workpiece<Dim>>(discretized(contact.setup->mesh()),
                                       std::make_shared<UserLaw<Dim>>(internal_names("")), UpdateOptions());
  material->fingerprint = mesh_fingerprint<Dim>(contact.setup->mesh());
  material->body = std::make_unique<RunBody<Dim>>(std::move(workpiece));
  return material;
}
bool start_forms(const Method<S, StartTag>& m, ContactHandle* const& contact) {
  return guarded([&] {
    auto material = visit(contact->get(), [](auto& object) { return unknown_material(object); });
    return start_run(m.object->share(), contact, std::move(material), true), true;
  });
}

// Only rcSolve moves u, and rcTangent by C.expand. What a script has written there is taken back, so that the run can end at its
// accepted state.
void require_untouched(const ControlObject& object, const Eigen::VectorXd& now, const KN_<double>& u) {
  if (!object.under_way() || object.stopping || object.task == Task::SOLVE) return;
  if (object.task == Task::TANGENT &&
      visit(*object.contact, [](auto& contact) { return contact.run().iteration().policy().condensed(); }))
    return;
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
long next(Stack, const Method<S, NextTag>& m, const KN_<double>& u, const KN_<double>& R) {
  return guarded([&] {
    ControlObject& object = m->get();
    StepLoop& stepper = object.running("stepcontrol.next");
    if (object.task == Task::RECORD) { // what it printed, into a file or pipe, too
      std::cout.flush();
      std::fflush(stdout);
    }
    return visit(*object.contact, [&](auto& contact) {
      const CpuTimer timer(contact.event_seconds);
      const long n = contact.setup->mesh().num_dofs();
      Eigen::VectorXd v = to_dofs(u, n, "stepcontrol.next", "u"),
                      force = to_dofs(R, n, "stepcontrol.next", "R");
      require_untouched(object, v, u);
      const double checks = contact.diagnosis.seconds(), linear = contact.linear_seconds();
      object.material->moduli_blend = -1;
      const Task task = called("contact.begin", [&] { return stepper.next(v, force); });
      const double checked = contact.diagnosis.seconds() - checks;
      contact.event_seconds -= checked + contact.linear_seconds() - linear;
      to_array(v, u, "stepcontrol.next");
      object.task = task;
      contact.under_way = object.under_way();
      object.u = std::move(v);
      to_array(force, R, "stepcontrol.next");
      *object.control = stepper.control();
      return static_cast<long>(task);
    });
  });
}
struct RefuseTag {};
struct StopTag {};
bool refuse(const Method<S, RefuseTag>& m, string* const& reason) {
  return guarded([&] { return m->get().running("stepcontrol.refuse").refuse(*reason), true; });
}
bool stop(const Method<S, StopTag>& m, string* const& reason) {
  return guarded([&] {
    m->get().running("stepcontrol.stop").stop(*reason);
    m->get().stopping = true;
    return true;
  });
}

struct SchemeTag {};
bool set_scheme(const Method<S, SchemeTag>& m, string* const& name) {
  return guarded([&] {
    ControlObject& object = m->get();
    Settings settings;
    set_choice(settings, setting("scheme"), *name, "stepcontrol");
    object.options.scheme = settings.stepper.scheme;
    if (object.stepper) object.stepper->set_scheme(object.options.scheme);
    return true;
  });
}

struct ChecksTag {};
bool set_checks(const Method<S, ChecksTag>& m, const bool& on) {
  return guarded([&] {
    ControlObject& object = m->get();
    object.checks = on;
    if (object.contact) visit(*object.contact, [&](auto& contact) { contact.diagnosis.set_checks(on); });
    return on;
  });
}
} // namespace

template <int Dim>
Stepper<Dim>& begin_stepper(const std::shared_ptr<ControlObject>& control, ContactOf<Dim>& contact,
                            MaterialOf<Dim>& material) {
  auto stepper = std::make_unique<Stepper<Dim>>(contact.run(), *material.body, contact.diagnosis,
                                                control->now(), control->options);
  contact.diagnosis.set_checks(control->checks);
  Stepper<Dim>& begun = *stepper;
  control->stepper = std::move(stepper);
  contact.runs.push_back([weak = std::weak_ptr<ControlObject>(control)] {
    if (const auto shared = weak.lock()) shared->stepper.reset();
  });
  return begun;
}
template Stepper<2>& begin_stepper<2>(const std::shared_ptr<ControlObject>&, ContactOf<2>&, MaterialOf<2>&);
template Stepper<3>& begin_stepper<3>(const std::shared_ptr<ControlObject>&, ContactOf<3>&, MaterialOf<3>&);

void register_step_control() {
  Dcl_Type<S*>(InitP<S>, Destroy<S>);
  zzzfff->Add("stepcontrol", atype<S*>());
  TheOperators->Add("<-", new NamedOperator<MakeStepControl, S*, S*, double>);
  add_method<S, StartTag>(
      "start",
      [] { return new OneOperator3_<bool, Method<S, StartTag>, ContactHandle*, MaterialHandle*>(start); },
      [] { return new OneOperator2_<bool, Method<S, StartTag>, ContactHandle*>(start_forms); });
  add_method<S, NextTag>(
      "next", [] { return new OneOperator3s_<long, Method<S, NextTag>, KN_<double>, KN_<double>>(next); });
  add_method<S, RefuseTag>("refuse",
                           [] { return new OneOperator2_<bool, Method<S, RefuseTag>, string*>(refuse); });
  add_method<S, SchemeTag>("scheme",
                           [] { return new OneOperator2_<bool, Method<S, SchemeTag>, string*>(set_scheme); });
  add_method<S, StopTag>("stop", [] { return new OneOperator2_<bool, Method<S, StopTag>, string*>(stop); });
  add_method<S, ChecksTag>("checks",
                           [] { return new OneOperator2_<bool, Method<S, ChecksTag>, bool>(set_checks); });
  register_step_data();
  register_scene_report();
  long number = 0;
  for (const char* name : {"rcProgram", "rcAcceptLaw", "rcRevertLaw", "rcForces", "rcTangent", "rcSolve",
                           "rcRecord", "rcFinished", "rcStopped"})
    Global.New(name, CConstant<long>(number++));
}

} // namespace burnish

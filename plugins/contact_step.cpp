// The verbs of a step, for a user-defined loop; rcRun calls them through S.next.
//   rcConverged, rcIterate, rcRefactorize, rcBacktracked, rcFailed   results of C.check and C.correct: take the step; another
//       iteration; a new tangent first; gone part of the way back, check again; shorten the step, C.reason tells why
//   C.begin(u, t, dt)   a step begins; the prescriptions have their values at t + dt
//     u         in: accepted, out: predicted displacement | length
//     t         start of the step | time | | finite
//     dt        its length | time | | > 0
//     events=   true: contact states stay fixed (event stepping) | | false
//     rates=    true: pure rates from the accepted state, see C.condense | | false
//     ! pure rates know no motion of supports; take the scheme implicit or event
//   C.check(u, R)   tests balance, gaps and states; returns a status such as rcConverged
//     u         displacement, may be moved | length
//     R         nodal forces, internal - external | force
//     ! no step is under way, call begin first
//   C.factorize(M, u)   factorizes the tangent for the next iterations; of a material with many nodes in contact it makes the next
//       iteration itself (ALGORITHMS.md 8.8), C.correct then has nothing to do; false: it cannot be done
//     M         a material, its own tangent; or a matrix, symmetric unless the solver takes any
//     u         displacement; moved by an iteration | length
//     solver=   solver of FreeFEM that keeps the factor: "UMFPACK", "CHOLMOD", ... | | "", the core's own | a solver that is loaded
//     ! unknown solver
//   C.correct(u, R)   one iteration: moves u, slips, coordinates and contact states; returns a status
//     u         in, out | length
//     R         nodal forces at u | force
//     ! this step has not been checked, call check first
//   C.events(u, R)   earliest event of contact as a fraction of the step, 2: none | -
//     u         displacement at the end | length
//     R         nodal forces there | force
//     tolerance=   events this close to the earliest one are taken with it, fraction of the step | - | 1e-3
//     until=    looks no further than this fraction | - | 1
//   C.acceptevents()   changes states at the accepted state without moving; returns how many | -
//   C.logevents(M)   appends the element events that M.events found in this step; returns how many | -
//     M         the material
//   C.accept(u, R)   the end of the step becomes the accepted state
//     u         that of the last check, which must have returned rcConverged | length
//     R         nodal forces there | force
//     ! the step has not converged: the last check did not return rcConverged
//   C.revert()   back to the accepted state
//   C.reason    why the last step failed
#include "base/error.hpp"
#include "matrix.hpp"
#include "named.hpp"
#include "run/workpiece_tangent.hpp"
#include "solver/block_symmetry.hpp"
#include "types.hpp"

namespace burnish {
namespace {

template <int Dim>
Eigen::VectorXd dofs(const ContactOf<Dim>& contact, const KN_<double>& a, const char* where,
                     const char* name) {
  return to_dofs(a, contact.setup->mesh().num_dofs(), where, name);
}

struct BeginTag {};
struct Begin {
  static const int n = 2;
  static basicAC_F0::name_and_type names[n];
  static Stepping stepping(const Named& a) {
    if (a.boolean("rates", false)) return Stepping::RATES;
    return a.boolean("events", false) ? Stepping::EVENT : Stepping::IMPLICIT;
  }
  static bool call(const Named& a, Method<ContactHandle, BeginTag> m, KN_<double> u, double t, double dt) {
    require(std::isfinite(t), "contact.begin", "t", t, "a finite number");
    return visit(m->get(), [&](auto& contact) {
      Eigen::VectorXd v = dofs(contact, u, "contact.begin", "u");
      contact.pending.clear();
      contact.step = {};
      called("contact.begin", [&] { contact.run().begin(v, t, dt, stepping(a)); });
      contact.step.rates = stepping(a) == Stepping::RATES;
      to_array(v, u, "contact.begin");
      return true;
    });
  }
};
basicAC_F0::name_and_type Begin::names[] = {{"events", &typeid(bool)}, {"rates", &typeid(bool)}};

// Check and correct move u; the status is the number of the enumerator.
template <class Verb>
long step_verb(ContactHandle* handle, const KN_<double>& u, const KN_<double>& R, const char* where,
               Verb verb) {
  return on(handle, [&](auto& contact) {
    if (contact.step.rates)
      fail(where, "a step of pure rates is solved once: condense(..., rates=true) and expand, then accept");
    Eigen::VectorXd v = dofs(contact, u, where, "u");
    const auto status = verb(contact.run(), v, dofs(contact, R, where, "R"));
    to_array(v, u, where);
    contact.step.converged = status == StepStatus::CONVERGED;
    if (contact.step.converged) contact.step.u = std::move(v);
    return static_cast<long>(status);
  });
}

struct CheckTag {};
struct CorrectTag {};
long check(Stack, const Method<ContactHandle, CheckTag>& m, const KN_<double>& u, const KN_<double>& R) {
  return step_verb(m.object, u, R, "contact.check",
                   [](auto& run, auto& v, const auto& r) { return run.check(v, r); });
}
long correct(Stack, const Method<ContactHandle, CorrectTag>& m, const KN_<double>& u, const KN_<double>& R) {
  return step_verb(m.object, u, R, "contact.correct",
                   [](auto& run, auto& v, const auto& r) { return run.correct(v, r); });
}

struct FactorizeTag {};
struct Factorize {
  static const int n = 1;
  static basicAC_F0::name_and_type names[n];
  static bool of_material(const Named& a, Method<ContactHandle, FactorizeTag> m, MaterialHandle* material,
                          KN_<double> u) {
    return visit(m->get(), [&](auto& contact) {
      auto& object = contact.with_material(material->get(), "contact.factorize");
      contact.material = material->share();
      contact.take_solver(a.text("solver", ""), a.stack(), "contact.factorize");
      Eigen::VectorXd v = dofs(contact, u, "contact.factorize", "u");
      const bool done = take_tangent(contact.run(), object.workpiece(), v);
      to_array(v, u, "contact.factorize");
      return done;
    });
  }
  static bool of_matrix(const Named& a, Method<ContactHandle, FactorizeTag> m, Matrice_Creuse<double>* K,
                        KN_<double> u) {
    return visit(m->get(), [&](auto& contact) {
      const auto& blocks = contact.blocks(view_of(K, contact.setup->mesh().num_dofs(), "contact.factorize"),
                                          "contact.factorize");
      contact.run().step().require_begun("contact.factorize");
      if (contact.take_solver(a.text("solver", ""), a.stack(), "contact.factorize"))
        require_symmetric(blocks, LARGEST_ASYMMETRY, "contact.factorize");
      return contact.run().factorize(blocks, dofs(contact, u, "contact.factorize", "u")) == FactorStatus::OK;
    });
  }
};
basicAC_F0::name_and_type Factorize::names[] = {{"solver", &typeid(string*)}};
struct FactorizeMaterial : Factorize {
  static constexpr auto call = of_material;
};
struct FactorizeMatrix : Factorize {
  static constexpr auto call = of_matrix;
};

struct EventsTag {};
struct Events {
  static const int n = 2;
  static basicAC_F0::name_and_type names[n];
  static double call(const Named& a, Method<ContactHandle, EventsTag> m, KN_<double> u, KN_<double> R) {
    return visit(m->get(), [&](auto& contact) {
      const CpuTimer timer(contact.event_seconds);
      contact.pending = contact.run().events(dofs(contact, u, "contact.events", "u"),
                                             dofs(contact, R, "contact.events", "R"),
                                             a.real("tolerance", 1e-3), a.real("until", 1));
      double first = 2;
      for (const auto& event : contact.pending) first = std::min(first, event.fraction);
      return first;
    });
  }
};
basicAC_F0::name_and_type Events::names[] = {{"tolerance", &typeid(double)}, {"until", &typeid(double)}};

struct LogTag {};
long log_events(const Method<ContactHandle, LogTag>& m, MaterialHandle* const& material) {
  return on(m.object, [&](auto& contact) {
    contact.run().step().require_begun("contact.logevents");
    const auto& events = contact.with_material(material->get(), "contact.logevents").body->pending();
    contact.run().log_elements(events);
    return static_cast<long>(events.size());
  });
}

struct AcceptEventsTag {};
long accept_events(const Method<ContactHandle, AcceptEventsTag>& m) {
  return on(m.object, [&](auto& contact) {
    contact.run().accept_events(contact.pending);
    const long n = static_cast<long>(contact.pending.size());
    contact.pending.clear();
    return n;
  });
}

struct AcceptTag {};
struct RevertTag {};
// A step of pure rates is solved, not iterated; the core refuses to accept what has not been checked.
template <int Dim> void require_converged(ContactOf<Dim>& contact, const Eigen::VectorXd& u) {
  contact.run().step().require_checked("contact.accept");
  const StepSeen& step = contact.step;
  if (step.rates) return;
  if (!step.converged)
    fail("contact.accept", "the step has not converged: the last check did not return rcConverged");
  for (Eigen::Index d = 0; d < u.size(); ++d)
    if (u[d] != step.u[d]) {
      std::ostringstream text;
      text << "u[" << d << "] = " << u[d] << ", expected " << step.u[d] << ", where the step has converged";
      fail("contact.accept", text.str());
    }
}
bool accept(Stack, const Method<ContactHandle, AcceptTag>& m, const KN_<double>& u, const KN_<double>& R) {
  return on(m.object, [&](auto& contact) {
    constexpr int Dim = dim_of<decltype(contact)>;
    const CpuTimer timer(contact.event_seconds);
    const Eigen::VectorXd v = dofs(contact, u, "contact.accept", "u");
    require_converged(contact, v);
    contact.diagnosis.begin(accepted_step<Dim>(contact.run(), nullptr));
    contact.run().accept(v, dofs(contact, R, "contact.accept", "R"), contact.pending);
    contact.diagnosis.look(accepted_step<Dim>(contact.run(), nullptr));
    contact.pending.clear();
    contact.step = {};
    return true;
  });
}
bool revert(const Method<ContactHandle, RevertTag>& m) {
  return on(m.object, [](auto& contact) {
    if (contact.started()) contact.run().revert();
    contact.pending.clear();
    contact.step = {};
    return true;
  });
}
string* reason(Stack stack, ContactHandle* const& h) {
  return on(h, [&](auto& contact) {
    return new_string(stack, contact.started() ? burnish::reason<dim_of<decltype(contact)>>(
                                                     contact.run(), contact.diagnosis, nullptr)
                                               : "");
  });
}

} // namespace

void register_contact_step() {
  using H = ContactHandle;
  using Array = KN_<double>;
  add_method<H, BeginTag>(
      "begin", [] { return new NamedOperator<Begin, bool, Method<H, BeginTag>, Array, double, double>; });
  add_method<H, CheckTag>("check",
                          [] { return new OneOperator3s_<long, Method<H, CheckTag>, Array, Array>(check); });
  add_method<H, CorrectTag>(
      "correct", [] { return new OneOperator3s_<long, Method<H, CorrectTag>, Array, Array>(correct); });
  add_method<H, FactorizeTag>(
      "factorize",
      [] {
        return new NamedOperator<FactorizeMaterial, bool, Method<H, FactorizeTag>, MaterialHandle*, Array>;
      },
      [] {
        return new NamedOperator<FactorizeMatrix, bool, Method<H, FactorizeTag>, Matrice_Creuse<double>*,
                                 Array>;
      });
  add_method<H, EventsTag>(
      "events", [] { return new NamedOperator<Events, double, Method<H, EventsTag>, Array, Array>; });
  add_method<H, LogTag>(
      "logevents", [] { return new OneOperator2_<long, Method<H, LogTag>, MaterialHandle*>(log_events); });
  add_method<H, AcceptEventsTag>(
      "acceptevents", [] { return new OneOperator1_<long, Method<H, AcceptEventsTag>>(accept_events); });
  add_method<H, AcceptTag>(
      "accept", [] { return new OneOperator3s_<bool, Method<H, AcceptTag>, Array, Array>(accept); });
  add_method<H, RevertTag>("revert", [] { return new OneOperator1_<bool, Method<H, RevertTag>>(revert); });
  Add<H*>("reason", ".", new OneOperator1s_<string*, H*>(reason));
  long number = 0;
  for (const char* name : {"rcConverged", "rcIterate", "rcRefactorize", "rcBacktracked", "rcFailed"})
    Global.New(name, CConstant<long>(number++));
}

} // namespace burnish

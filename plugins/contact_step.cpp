// The verbs of a step: C.begin, check, factorize, correct, events, switchstates, accept, revert.
//   C.begin(u[], t, dt);  C.begin(u[], t, dt, events=true);
//   int st = C.check(u[], R);            rcConverged, rcIterate, rcRefactorize, rcHalved, rcFailed
//   int ok = C.factorize(M, u[]);        the material's own tangent; or C.factorize(K, u[]) with any
//   symmetric matrix int st = C.correct(u[], R);          real f = C.events(u[], R);   2 if the step has no
//   event
#include "base/error.hpp"
#include "matrix.hpp"
#include "named.hpp"
#include "types.hpp"

namespace rigidcontact {
namespace {

struct BeginTag {};
struct Begin {
  static const int n = 1;
  static basicAC_F0::name_and_type names[n];
  static bool call(const Named& a, Method<ContactHandle, BeginTag> m, KN_<double> u, double t, double dt) {
    Eigen::VectorXd v = to_vector(u, "contact.begin", "u");
    m->get().session->begin(
        v, t, dt, a.boolean("events", false) ? burnish::Stepping::EVENT : burnish::Stepping::IMPLICIT);
    m->get().pending.clear();
    to_array(v, u, "contact.begin");
    return true;
  }
};
basicAC_F0::name_and_type Begin::names[] = {{"events", &typeid(bool)}};

// Check and correct move u; the status is the number of the enumerator.
template <class Verb>
long step_verb(ContactHandle* handle, const KN_<double>& u, const KN_<double>& R, const char* where,
               Verb verb) {
  return guarded([&] {
    Session<2>& session = *handle->get().session;
    if (!session.started()) burnish::fail(where, "call begin first");
    Eigen::VectorXd v = to_vector(u, where, "u");
    const auto status = verb(session, v, to_vector(R, where, "R"));
    to_array(v, u, where);
    return static_cast<long>(status);
  });
}

struct CheckTag {};
struct CorrectTag {};
long check(Stack, const Method<ContactHandle, CheckTag>& m, const KN_<double>& u, const KN_<double>& R) {
  return step_verb(m.object, u, R, "contact.check",
                   [](auto& s, auto& v, const auto& r) { return s.check(v, r); });
}
long correct(Stack, const Method<ContactHandle, CorrectTag>& m, const KN_<double>& u, const KN_<double>& R) {
  return step_verb(m.object, u, R, "contact.correct",
                   [](auto& s, auto& v, const auto& r) { return s.correct(v, r); });
}

struct FactorizeTag {};
// Mixes in elastic moduli until the tangent is positive definite; false: it stays indefinite.
bool factorize_material(const Method<ContactHandle, FactorizeTag>& m, MaterialHandle* const& material,
                        const KN_<double>& u) {
  return guarded([&] {
    Session<2>& session = *m->get().session;
    MaterialObject& object = material->get();
    const Eigen::VectorXd v = to_vector(u, "contact.factorize", "u");
    if (!session.started()) burnish::fail("contact.factorize", "call begin first");
    do {
      {
        const burnish::CpuTimer timer(object.assembly_seconds);
        object.body->tangent(object.tangent, burnish::TangentKind::CONSISTENT,
                             session.corrector().elastic_blend());
      }
      if (session.factorize(object.tangent, v) == burnish::FactorStatus::OK) return true;
    } while (!session.corrector().blend_exhausted());
    return false;
  });
}
bool factorize_matrix(const Method<ContactHandle, FactorizeTag>& m, Matrice_Creuse<double>* const& K,
                      const KN_<double>& u) {
  return guarded([&] {
    ContactObject& contact = m->get();
    if (!contact.session->started()) burnish::fail("contact.factorize", "call begin first");
    const auto& blocks = contact.reader.read(view_of(K, "contact.factorize"));
    return contact.session->factorize(blocks, to_vector(u, "contact.factorize", "u")) ==
           burnish::FactorStatus::OK;
  });
}

struct EventsTag {};
double events(Stack, const Method<ContactHandle, EventsTag>& m, const KN_<double>& u, const KN_<double>& R) {
  return guarded([&] {
    ContactObject& contact = m->get();
    const burnish::CpuTimer timer(contact.event_seconds);
    contact.pending =
        contact.session->events(to_vector(u, "contact.events", "u"), to_vector(R, "contact.events", "R"));
    double first = 2;
    for (const auto& event : contact.pending) first = std::min(first, event.fraction);
    return first;
  });
}

struct SwitchTag {};
long switch_states(const Method<ContactHandle, SwitchTag>& m) {
  return guarded([&] {
    ContactObject& contact = m->get();
    contact.session->switch_states(contact.pending);
    const long n = static_cast<long>(contact.pending.size());
    contact.pending.clear();
    return n;
  });
}

struct AcceptTag {};
struct RevertTag {};
bool accept(Stack, const Method<ContactHandle, AcceptTag>& m, const KN_<double>& u, const KN_<double>& R) {
  return guarded([&] {
    ContactObject& contact = m->get();
    const burnish::CpuTimer timer(contact.event_seconds);
    contact.session->accept(to_vector(u, "contact.accept", "u"), to_vector(R, "contact.accept", "R"),
                            contact.pending);
    contact.pending.clear();
    return true;
  });
}
bool revert(const Method<ContactHandle, RevertTag>& m) {
  return guarded([&] {
    m->get().session->revert();
    m->get().pending.clear();
    return true;
  });
}
string* reason(Stack stack, ContactHandle* const& h) {
  return guarded([&] {
    return new_string(stack, h->get().session->started() ? h->get().session->corrector().reason() : "");
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
        return new OneOperator3_<bool, Method<H, FactorizeTag>, MaterialHandle*, Array>(factorize_material);
      },
      [] {
        return new OneOperator3_<bool, Method<H, FactorizeTag>, Matrice_Creuse<double>*, Array>(
            factorize_matrix);
      });
  add_method<H, EventsTag>(
      "events", [] { return new OneOperator3s_<double, Method<H, EventsTag>, Array, Array>(events); });
  add_method<H, SwitchTag>("switchstates",
                           [] { return new OneOperator1_<long, Method<H, SwitchTag>>(switch_states); });
  add_method<H, AcceptTag>(
      "accept", [] { return new OneOperator3s_<bool, Method<H, AcceptTag>, Array, Array>(accept); });
  add_method<H, RevertTag>("revert", [] { return new OneOperator1_<bool, Method<H, RevertTag>>(revert); });
  Add<H*>("reason", ".", new OneOperator1s_<string*, H*>(reason));
  long number = 0;
  for (const char* name : {"rcConverged", "rcIterate", "rcRefactorize", "rcHalved", "rcFailed"})
    Global.New(name, CConstant<long>(number++));
}

} // namespace rigidcontact

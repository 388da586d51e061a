// The condensed matrix for any FreeFEM solver:
//   matrix Kh = C.condense(K, u[], R);    named: terms="complete"|"article"|"none", rates=false,
//   symmetric=false set(Kh, solver="UMFPACK");            or "BURNISH" (attached already), CHOLMOD with
//   symmetric=true, ... real[int] z = Kh^-1 * C.rhs;          real largest = C.expand(z, u[]);
#include "base/error.hpp"
#include "matrix.hpp"
#include "named.hpp"
#include "types.hpp"

namespace rigidcontact {
namespace {

struct CondenseTag {};
struct Condense {
  static const int n = 3;
  static basicAC_F0::name_and_type names[n];
  static newpMatrice_Creuse<double> call(const Named& a, Method<ContactHandle, CondenseTag> m,
                                         Matrice_Creuse<double>* K, KN_<double> u, KN_<double> R) {
    ContactObject& contact = m->get();
    if (!contact.session->started()) burnish::fail("contact.condense", "call begin first");
    const burnish::CpuTimer timer(contact.condense_seconds);
    const auto& blocks = contact.reader.read(view_of(K, "contact.condense"));
    const auto right =
        a.boolean("rates", false) ? burnish::RightHandSide::RATES : burnish::RightHandSide::TOTAL;
    const auto& system = contact.session->condense(
        blocks, to_vector(u, "contact.condense", "u"), to_vector(R, "contact.condense", "R"),
        terms_of(a.text("terms", "complete")), right, a.boolean("symmetric", false));
    contact.rhs.assign(system.rhs.data(), system.rhs.data() + system.rhs.size());
    return to_freefem(a.stack(), system);
  }
};
basicAC_F0::name_and_type Condense::names[] = {
    {"terms", &typeid(string*)}, {"rates", &typeid(bool)}, {"symmetric", &typeid(bool)}};

KN_<double> right_hand_side(Stack stack, ContactHandle* const& h) {
  return guarded([&] { return new_array(stack, h->get().rhs); });
}

struct ExpandTag {};
double expand(Stack, const Method<ContactHandle, ExpandTag>& m, const KN_<double>& z, const KN_<double>& u) {
  return guarded([&] {
    Eigen::VectorXd v = to_vector(u, "contact.expand", "u");
    const double largest = m->get().session->expand(to_vector(z, "contact.expand", "z"), v);
    to_array(v, u, "contact.expand");
    return largest;
  });
}

} // namespace

void register_contact_matrix() {
  using H = ContactHandle;
  using Array = KN_<double>;
  add_method<H, CondenseTag>("condense", [] {
    return new NamedOperator<Condense, newpMatrice_Creuse<double>, Method<H, CondenseTag>,
                             Matrice_Creuse<double>*, Array, Array>;
  });
  Add<H*>("rhs", ".", new OneOperator1s_<Array, H*>(right_hand_side));
  add_method<H, ExpandTag>(
      "expand", [] { return new OneOperator3s_<double, Method<H, ExpandTag>, Array, Array>(expand); });
}

} // namespace rigidcontact

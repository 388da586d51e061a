// The condensed matrix for any FreeFEM solver.
//   > matrix Kh = C.condense(K, u[], R, solver="UMFPACK");
//   > real[int] z = Kh^-1 * C.rhs;
//   > C.expand(z, u[]);
//   C.condense(K, u, R)   matrix of the nodal and tool increments; its right-hand side is C.rhs
//     K         tangent, from varf or M.tangent() | force/length | | symmetric with symmetric=true
//     u         displacement | length
//     R         nodal forces, internal - external | force
//     terms=    geometric terms | | that of rcContact | "complete", "article", "none"
//     rates=    true: right-hand side of pure rates, after C.begin(..., rates=true) | | false
//     symmetric=   true: one triangle, for CHOLMOD and its like; without friction, or with frictiontangent="lagged" | | false
//     solver=   solver of FreeFEM attached to the matrix, or "BURNISH" | | "BURNISH" | a solver that is loaded
//     ! needs symmetric=true
//     ! the force array contains NaN or Inf
//   C.rhs       right-hand side of the last condensed matrix
//   C.expand(z, u)   nodal and tool increments from the solution; returns the largest nodal one | length
//     z         solution
//     u         in, out | length
//   C.given     per degree of freedom: 1 where the displacement is given | -
//   C.again     contact states have changed, nothing has moved: condense and solve anew with the same K, R
//       (or go on: C.check then asks for another iteration)
//   C.condensed(name)   of the last condensed matrix | -
//     name      "size", "nonzeros", "asymmetry": largest |k_ij - k_ji| over the largest entry
//     ! no matrix has been condensed yet
//   C.elasticblend   part of elastic moduli that the next tangent should have in plastic points, after losses of definiteness | -
//   C.blendexhausted   true: no more of that helps
//   C.set(name, value)   another value of a setting of rcContact, from the next iteration on
//     name      "stepsperfactor", say
//     value     a number, or a word where it is a choice
//     ! no setting of rcContact
//   C.cut(u, fraction)   a step of pure rates is shortened: everything is linear in it
//     u         in, out | length
//     fraction   part that is kept | - | | 0 < fraction <= 1
//     ! only a step of pure rates is linear: begin it with rates=true
#include "base/error.hpp"
#include "freefem_solver.hpp"
#include "matrix.hpp"
#include "named.hpp"
#include "settings.hpp"
#include "solver/asymmetry.hpp"
#include "solver/block_symmetry.hpp"
#include "types.hpp"

namespace burnish {
namespace {

struct CondenseTag {};
struct Condense {
  static const int n = 4;
  static basicAC_F0::name_and_type names[n];
  static newpMatrice_Creuse<double> call(const Named& a, Method<ContactHandle, CondenseTag> m,
                                         Matrice_Creuse<double>* K, KN_<double> u, KN_<double> R) {
    const std::string solver = known_solver(a.text("solver", "BURNISH"), "contact.condense");
    const bool symmetric = a.boolean("symmetric", false);
    if (!symmetric && takes_triangle(solver)) // it would read one triangle only and answer wrongly
      fail("contact.condense", "solver \"" + solver + "\" needs symmetric=true");
    return visit(m->get(), [&](auto& contact) {
      const long n = contact.setup->mesh().num_dofs();
      const CpuTimer timer(contact.condense_seconds);
      const auto& blocks = contact.blocks(view_of(K, n, "contact.condense"), "contact.condense");
      if (symmetric) require_symmetric(blocks, LARGEST_ASYMMETRY, "contact.condense");
      const GeometricTerms terms = terms_of(a, contact.run().iteration().options().terms);
      const auto right = a.boolean("rates", false) ? RightHandSide::RATES : RightHandSide::TOTAL;
      const auto& system = called("contact.condense", [&]() -> const CondensedSystem& {
        return contact.run().condensed().condense(blocks, to_dofs(u, n, "contact.condense", "u"),
                                                  to_dofs(R, n, "contact.condense", "R"), terms, right,
                                                  symmetric);
      });
      contact.condensed = &system;
      contact.rhs.assign(system.rhs.data(), system.rhs.data() + system.rhs.size());
      return to_freefem(a.stack(), system, solver);
    });
  }

private:
  static GeometricTerms terms_of(const Named& a, GeometricTerms otherwise) {
    Settings settings;
    settings.iteration.terms = otherwise;
    if (a.has("terms")) set_choice(settings, setting("terms"), a.text("terms", ""), "contact.condense");
    return settings.iteration.terms;
  }
};
basicAC_F0::name_and_type Condense::names[] = {{"terms", &typeid(string*)},
                                               {"rates", &typeid(bool)},
                                               {"symmetric", &typeid(bool)},
                                               {"solver", &typeid(string*)}};

struct MatrixTag {};
double matrix_number(const Method<ContactHandle, MatrixTag>& m, string* const& name) {
  return guarded([&]() -> double {
    const CondensedSystem* system = m->get().condensed;
    if (!system) fail("contact.condensed", "no matrix has been condensed yet");
    const SparseView view{system->n, system->row_start.data(), system->col.data(), system->value.data(),
                          system->half};
    if (*name == "size") return system->n;
    if (*name == "nonzeros") return system->row_start[system->n];
    if (*name == "asymmetry") return largest_asymmetry(view);
    fail("contact.condensed", "unknown name \"" + *name + "\", expected size, nonzeros or asymmetry");
  });
}

KN_<double> given(Stack stack, ContactHandle* const& h) {
  return on(h, [&](auto& contact) {
    const auto& fixed = contact.run().setup().body().fixed;
    return new_array(stack, std::vector<double>(fixed.begin(), fixed.end()));
  });
}
double elastic_blend(ContactHandle* const& h) {
  return on(h, [](auto& contact) { return contact.run().iteration().policy().elastic_blend(); });
}
bool again(ContactHandle* const& h) {
  return on(h, [](auto& contact) { return contact.run().condensed().again(); });
}
bool blend_exhausted(ContactHandle* const& h) {
  return on(h, [](auto& contact) { return contact.run().iteration().policy().blend_exhausted(); });
}

KN_<double> right_hand_side(Stack stack, ContactHandle* const& h) {
  return guarded([&] { return new_array(stack, h->get().rhs); });
}

struct ExpandTag {};
double expand(Stack, const Method<ContactHandle, ExpandTag>& m, const KN_<double>& z, const KN_<double>& u) {
  return on(m.object, [&](auto& contact) {
    Eigen::VectorXd v = to_dofs(u, contact.setup->mesh().num_dofs(), "contact.expand", "u");
    const Eigen::VectorXd solution = to_vector(z, "contact.expand", "z");
    const double largest =
        called("contact.expand", [&] { return contact.run().condensed().expand(solution, v); });
    to_array(v, u, "contact.expand");
    return largest;
  });
}

struct SetTag {};
template <class Value>
bool set(const Method<ContactHandle, SetTag>& m, string* const& name, const Value& value) {
  return on(m.object, [&](auto& contact) {
    const Setting& one = setting(*name);
    if (std::string(one.owner) != "rcContact") fail("contact.set", *name + " is no setting of rcContact");
    IterationOptions& options = contact.started() ? contact.run().iteration().options() : contact.options;
    Settings all;
    all.iteration = options;
    if constexpr (std::is_arithmetic_v<Value>)
      set_number(all, one, static_cast<double>(value), "contact", *name);
    else
      set_choice(all, one, *value, "contact");
    options = all.iteration;
    return true;
  });
}

struct CutTag {};
bool cut(Stack, const Method<ContactHandle, CutTag>& m, const KN_<double>& u, const double& fraction) {
  return on(m.object, [&](auto& contact) {
    Eigen::VectorXd v = to_dofs(u, contact.setup->mesh().num_dofs(), "contact.cut", "u");
    contact.run().condensed().cut(v, fraction);
    to_array(v, u, "contact.cut");
    return true;
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
  add_method<H, MatrixTag>(
      "condensed", [] { return new OneOperator2_<double, Method<H, MatrixTag>, string*>(matrix_number); });
  Add<H*>("given", ".", new OneOperator1s_<Array, H*>(given));
  Add<H*>("again", ".", new OneOperator1_<bool, H*>(again));
  Add<H*>("elasticblend", ".", new OneOperator1_<double, H*>(elastic_blend));
  Add<H*>("blendexhausted", ".", new OneOperator1_<bool, H*>(blend_exhausted));
  Add<H*>("rhs", ".", new OneOperator1s_<Array, H*>(right_hand_side));
  add_method<H, CutTag>("cut",
                        [] { return new OneOperator3s_<bool, Method<H, CutTag>, Array, double>(cut); });
  add_method<H, SetTag>(
      "set", [] { return new OneOperator3_<bool, Method<H, SetTag>, string*, double>(set<double>); },
      [] { return new OneOperator3_<bool, Method<H, SetTag>, string*, long>(set<long>); },
      [] { return new OneOperator3_<bool, Method<H, SetTag>, string*, string*>(set<string*>); });
  add_method<H, ExpandTag>(
      "expand", [] { return new OneOperator3s_<double, Method<H, ExpandTag>, Array, Array>(expand); });
}

} // namespace burnish

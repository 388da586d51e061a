// A workpiece that is under stress, or has flowed, before its first step: from a heat treatment, another program, a file.
//   > real[int] x(0), y(0), weight(0);      rcPoints(M, x, y, weight);      // places of the points
//   > for (int i = 0; i < M.points; ++i) sxx[i] = 200*(1 - 6*y[i]^2);
//   > rcInitialStress(C, M, sxx, zero, zero, zero);
//   rcInitialStress(C, M, sxx, syy, szz, sxy)   before the first step: stress of the undeformed body in the plane, zz: hoop where
//       axisymmetric. Prints what is out of balance, and returns it: the largest nodal force that no support of C takes, the first
//       step lets go of it | force
//     C         contact
//     M         material
//     sxx       one per point, in the order of M.stress(i) | stress | | finite, within the yield surface
//     syy       the same | stress | | finite
//     szz       the same | stress | | finite
//     sxy       the same | stress | | finite
//   rcInitialStress(C, M, sxx, syy, szz, sxy, syz, szx)   the same in space
//     syz       one per point | stress | | finite
//     szx       the same | stress | | finite
//   M.initial(name, values)   before rcInitialStress: an internal variable of the undeformed body
//     name      one of M.internalvariables: "plastic_strain_eq"
//     values    one per point | its own | | finite, a plastic strain >= 0
//   M.initial(name, i, values)   a component of a tensor, in the order of M.stress(i)
//     name      "backstress"
//     i         component | - | | 0 to 3, in space 0 to 5
//     values    one per point | its own | | finite
//     ! expected one before its first step
//     ! times the yield stress, expected at most 1
#include "workpiece/initial_values.hpp"
#include "named.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using Array = KN_<double>;

struct InitialTag {};
bool initial_component(Stack, const Method<MaterialHandle, InitialTag>& m, string* const& name, const long& i,
                       const Array& values) {
  return on(m.object, [&](auto& material) {
    set_initial_variable(material.changed().workpiece(), *name, static_cast<int>(i), values_of(values),
                         "material.initial");
    return true;
  });
}
bool initial(const Method<MaterialHandle, InitialTag>& m, string* const& name, const Array& values) {
  return initial_component(nullptr, m, name, 0, values);
}

template <int Dim> struct InitialStress {
  static const int n = 0;
  static constexpr basicAC_F0::name_and_type* names = nullptr;
  template <class... Arrays>
  static double call(const Named&, ContactHandle* c, MaterialHandle* m, Arrays... components) {
    constexpr const char* WHERE = "rcInitialStress";
    auto& contact = of_dimension<Dim>(c->get(), WHERE);
    auto& body = contact.with_material(m->get(), WHERE).changed().workpiece();
    set_initial_stress<Dim>(body, {values_of(components)...}, WHERE);
    const OutOfBalance found = out_of_balance(body, contact.setup->body().fixed);
    cout << "burnish: initial stress: largest nodal force " << found.largest << ", of what no support takes "
         << found.unbalanced << endl;
    return found.unbalanced;
  }
};

} // namespace

void register_initial_values() {
  add_method<MaterialHandle, InitialTag>(
      "initial",
      [] { return new OneOperator3_<bool, Method<MaterialHandle, InitialTag>, string*, Array>(initial); },
      [] {
        return new OneOperator4s_<bool, Method<MaterialHandle, InitialTag>, string*, long, Array>(
            initial_component);
      });
  Global.Add("rcInitialStress", "(",
             new NamedOperator<InitialStress<2>, double, ContactHandle*, MaterialHandle*, Array, Array, Array,
                               Array>);
  Global.Add("rcInitialStress", "(",
             new NamedOperator<InitialStress<3>, double, ContactHandle*, MaterialHandle*, Array, Array, Array,
                               Array, Array, Array>);
}

} // namespace burnish

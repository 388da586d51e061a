// What carries the workpiece beside tools, from the next step on.
//   C.supportdisplacement(g)   displacement of the supports at the end of the step to come, until another is given
//       (METHOD.md 3.15). After a new mesh it counts on from the first one; of a formula of x, y the places are those of the new mesh:
//       give each support one value
//     g         as long as u, 0 at free components | length | 0 | finite
//   C.external(f)   external nodal forces of the steps to come, until others are given: weight, pressure. The core takes
//       them off: R of C.check and the like is the internal force
//     > varf weight([u, v], [a, b]) = int2d(Th)(-rho*g*b);
//     > real[int] f = weight(0, Vh);      C.external(f);
//     > // in program: a pressure p that follows the surface of label 2; [u, v] is the accepted displacement: it lags by a step
//     > varf pressure([x1, y1], [a, b]) = int1d(Th, 2)(-p*(N.x*(1 + dy(v)) - N.y*dx(v))*a - p*(N.y*(1 + dx(u)) - N.x*dy(u))*b);
//     f         as long as u; zeros take them back | force | none | finite
//     ! the forces are those of the mesh before
//     ! pure rates know no external forces; take the scheme implicit or event
//   C.hold(stiffness, until)   springs from all nodes to where they are when the next step begins; they fall linearly to 0
//       (METHOD.md 3.16)
//     stiffness   per reference volume | stress/length^2 | | finite > 0
//     until     when they are gone | time | | later than the start of the step
#include "named.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using H = ContactHandle;
using Array = KN_<double>;

struct SupportTag {};
bool support_displacement(Stack, const Method<H, SupportTag>& m, const Array& values) {
  return on(m.object,
            [&](auto& contact) { return contact.run().loads().supports.prescribe(values_of(values)), true; });
}
struct LoadTag {};
bool external(Stack, const Method<H, LoadTag>& m, const Array& forces) {
  return on(m.object,
            [&](auto& contact) { return contact.run().loads().external.prescribe(values_of(forces)), true; });
}
struct HoldTag {};
bool hold(const Method<H, HoldTag>& m, const double& stiffness, const double& until) {
  return on(m.object, [&](auto& contact) { return contact.run().loads().hold.set(stiffness, until), true; });
}

} // namespace

void register_contact_supports() {
  add_method<H, SupportTag>("supportdisplacement", [] {
    return new OneOperator2s_<bool, Method<H, SupportTag>, Array>(support_displacement);
  });
  add_method<H, LoadTag>("external",
                         [] { return new OneOperator2s_<bool, Method<H, LoadTag>, Array>(external); });
  add_method<H, HoldTag>("hold",
                         [] { return new OneOperator3_<bool, Method<H, HoldTag>, double, double>(hold); });
}

} // namespace burnish

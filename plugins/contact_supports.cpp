// What carries the workpiece beside tools, from the next step on.
//   C.supportdisplacement(g)   displacement of the supports at the end of the step to come, until another is given
//       (METHOD.md 3.15)
//     g         as long as u, 0 at free components | length | 0 | finite
//   C.hold(stiffness, until)   springs from all nodes to where they are when the next step begins; they fall linearly to 0
//       (METHOD.md 3.16)
//     stiffness   per reference volume | stress/length^2 | | finite > 0
//     until     when they are gone | time | | later than the start of the step
//   C.addhold(u, R)   its force into R after rcResidual, in a user-defined loop; rcRun does it by itself
//     u         displacement | length
//     R         in, out | force
//     ! no step is under way, call begin first
#include "named.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using H = ContactHandle;
using Array = KN_<double>;

struct SupportTag {};
bool support_displacement(Stack, const Method<H, SupportTag>& m, const KN_<double>& values) {
  return guarded([&] {
    ContactObject& contact = m->get();
    Eigen::VectorXd v(values.N());
    for (long d = 0; d < values.N(); ++d) v[d] = values[d];
    contact.run().supports().prescribe(v);
    return true;
  });
}
struct HoldTag {};
bool hold(const Method<H, HoldTag>& m, const double& stiffness, const double& until) {
  return guarded([&] { return m->get().run().hold().set(stiffness, until), true; });
}
struct AddHoldTag {};
bool add_hold(Stack, const Method<H, AddHoldTag>& m, const KN_<double>& u, const KN_<double>& R) {
  return guarded([&] {
    ContactObject& contact = m->get();
    contact.run().require_begun("contact.addhold");
    const long n = contact.setup->mesh().num_dofs();
    Eigen::VectorXd force = to_dofs(R, n, "contact.addhold", "R");
    contact.run().add_hold(to_dofs(u, n, "contact.addhold", "u"), force);
    to_array(force, R, "contact.addhold");
    return true;
  });
}

} // namespace

void register_contact_supports() {
  add_method<H, SupportTag>("supportdisplacement", [] {
    return new OneOperator2s_<bool, Method<H, SupportTag>, Array>(support_displacement);
  });
  add_method<H, HoldTag>("hold",
                         [] { return new OneOperator3_<bool, Method<H, HoldTag>, double, double>(hold); });
  add_method<H, AddHoldTag>(
      "addhold", [] { return new OneOperator3s_<bool, Method<H, AddHoldTag>, Array, Array>(add_hold); });
}

} // namespace burnish

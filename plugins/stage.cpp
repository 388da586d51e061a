// A run that starts from the end of another one.
//   rcStart(C, M, u, file)   before the first run of C: the workpiece as a run left it that wrote this file, S.checkpoint(file) after its
//       rcRun. Displacement, stress, internal variables, integrities are exactly those; tools, supports, labels and steps may be others.
//       Prints what is out of balance there, and returns it: the largest nodal force that no support of C takes | force
//     C         contact
//     M         material on the same mesh
//     u         displacement array, u[], out | length
//     file      path
//     ! expected one before its first step
#include "checkpoint/stage.hpp"
#include "base/error.hpp"
#include "types.hpp"

namespace burnish {
namespace {

double start_from(ContactHandle* const& contact, MaterialHandle* const& material, const KN_<double>& u,
                  string* const& path) {
  return on(contact, [&](auto& object) {
    constexpr const char* WHERE = "rcStart";
    auto& body = object.with_material(material->get(), WHERE);
    if (object.started() && object.run().accepted().history.dt > 0)
      fail(WHERE, "the contact has a run behind it, expected one before its first step");
    const StageStart start = start_stage(*path, object.setup->body().fixed, body.changed().workpiece());
    to_array(body.workpiece().state_old().displacement, u, WHERE);
    cout << "burnish: starts from " << *path << ", t = " << start.t << ": largest nodal force "
         << start.balance.largest << ", of what no support takes " << start.balance.unbalanced << endl;
    if (!start.same_material)
      cout << "burnish: warning: the material is described by other numbers than that of " << *path << endl;
    return start.balance.unbalanced;
  });
}

} // namespace

void register_stage() {
  Global.Add("rcStart", "(",
             new OneOperator4_<double, ContactHandle*, MaterialHandle*, KN_<double>, string*>(start_from));
}

} // namespace burnish

#include "run/run_archive.hpp"
#include "base/packed.hpp"
#include "contact/contact_archive.hpp"
#include "iteration/iteration_archive.hpp"
#include "workpiece/workpiece_archive.hpp"

namespace burnish {

template <class Archive, int Dim> void serialize(Archive& archive, BodyState<Dim>& value) {
  BURNISH_MEMBERS(value, workpiece, user, step_error);
}
template <class Archive> void serialize(Archive& archive, HoldState& value) {
  BURNISH_MEMBERS(value, stiffness, from, until, origin, factor, share);
}
template <class Archive> void serialize(Archive& archive, JumpMemory& value) {
  BURNISH_MEMBERS(value, number, dissipated, work);
}
template <class Archive, int Dim> void serialize(Archive& archive, EventLog<Dim>& value) {
  BURNISH_MEMBERS(value, events);
}
template <class Archive, int Dim> void serialize(Archive& archive, ContactRunState<Dim>& value) {
  BURNISH_MEMBERS(value, contact, references, u, R, generalized_force, prescribed, history,
                  support_displacement, support_origin, external, external_lost, hold, jumps, load, factor,
                  largest_dt, log, left_out, counts);
}
template <class Archive> void serialize(Archive& archive, StepControlState& value) {
  BURNISH_MEMBERS(value, t, dt, last_dt, failed_dt, cap, first, width, error);
}
template <class Archive> void serialize(Archive& archive, SchemeCounts& value) {
  BURNISH_MEMBERS(value, pieces, pileups, at_once, blind, excess);
}
template <class Archive> void serialize(Archive& archive, StepperCounts& value) {
  BURNISH_MEMBERS(value, steps, rejected, rolling, travel, scheme);
}
template <class Archive, int Dim> void serialize(Archive& archive, RunState<Dim>& value) {
  BURNISH_MEMBERS(value, body, contact, control, counts, diagnosis, drives, scheme, last_rejection,
                  rejected_dt);
}

template <int Dim> std::string packed(const RunState<Dim>& state) { return bytes_of<Dim>(state); }
template <int Dim> RunState<Dim> unpacked(const std::string& bytes) {
  return value_of_bytes<Dim, RunState<Dim>>(bytes, "unpacked", "state");
}

template std::string packed<2>(const RunState<2>&);
template std::string packed<3>(const RunState<3>&);
template RunState<2> unpacked<2>(const std::string&);
template RunState<3> unpacked<3>(const std::string&);

} // namespace burnish

#include "run/run_archive.hpp"
#include "base/error.hpp"
#include "contact/contact_archive.hpp"
#include "iteration/iteration_archive.hpp"
#include "workpiece/workpiece_archive.hpp"
#include <sstream>

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
                  support_displacement, external, hold, jumps, load, factor, largest_dt, log, left_out,
                  counts);
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

template <int Dim> std::string packed(const RunState<Dim>& state) {
  std::ostringstream bytes(std::ios::binary);
  {
    Writer archive(bytes);
    archive(Dim, state);
  }
  return bytes.str();
}

template <int Dim> RunState<Dim> unpacked(const std::string& bytes) {
  std::istringstream stream(bytes, std::ios::binary);
  RunState<Dim> state;
  try {
    Reader archive(stream);
    int dimension = 0;
    archive(dimension);
    require(dimension == Dim, "unpacked", "dimension of the state", dimension, std::to_string(Dim).c_str());
    archive(state);
  } catch (const cereal::Exception& error) {
    fail("unpacked", std::string("no state of a run: ") + error.what());
  }
  return state;
}

template std::string packed<2>(const RunState<2>&);
template std::string packed<3>(const RunState<3>&);
template RunState<2> unpacked<2>(const std::string&);
template RunState<3> unpacked<3>(const std::string&);

} // namespace burnish

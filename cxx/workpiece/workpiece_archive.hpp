#pragma once
// State of a workpiece, its user-defined events and step errors, into a file and from one (base/archive.hpp).
#include "base/archive.hpp"
#include "workpiece/point_events.hpp"
#include "workpiece/step_error.hpp"
#include "workpiece/workpiece_state.hpp"

namespace burnish {

template <class Archive, int Dim> void serialize(Archive& archive, WorkpieceState<Dim>& value) {
  BURNISH_MEMBERS(value, displacement, F, stress, internal, strain_increment, plastic, dt, integrity,
                  integrity_rate, integrity_goal);
}
template <class Archive> void serialize(Archive& archive, PointEventState& value) {
  BURNISH_MEMBERS(value, name, above, count);
}
template <class Archive> void serialize(Archive& archive, StepErrorState& value) {
  BURNISH_MEMBERS(value, last, weighted, strain);
}

} // namespace burnish

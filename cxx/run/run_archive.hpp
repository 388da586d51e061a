#pragma once
// RunState as bytes and back: a run goes on from them to the same bits.
#include "run/stepper.hpp"
#include <string>

namespace burnish {

template <int Dim> std::string packed(const RunState<Dim>& state);
/// @throws std::invalid_argument if the bytes are not those of a state of this dimension
template <int Dim> RunState<Dim> unpacked(const std::string& bytes);

} // namespace burnish

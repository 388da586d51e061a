#pragma once
// The list of all observers.
#include "diagnosis/observer.hpp"

namespace burnish {

/// What explains failed steps, the first cause first, and warns of the same in accepted ones.
template <int Dim> ObserverList<Dim> causes();
/// Checks, warnings and statements.
template <int Dim> ObserverList<Dim> checks();

#define BURNISH_MAKER(NAME) template <int Dim> std::unique_ptr<Observer<Dim>> NAME();
// cxx/diagnosis/step
BURNISH_MAKER(program_jump)
BURNISH_MAKER(pulling_force)
BURNISH_MAKER(unheld_workpiece)
BURNISH_MAKER(incompressible_workpiece)
BURNISH_MAKER(force_over_way)
BURNISH_MAKER(last_equilibrium)
BURNISH_MAKER(end_of_tool)
BURNISH_MAKER(few_nodes_hold)
// cxx/diagnosis/accepted: warnings of the scene
BURNISH_MAKER(tight_radius)
BURNISH_MAKER(tools_compete)
BURNISH_MAKER(hold_carries)
// self-checks, ALGORITHMS.md 16
BURNISH_MAKER(balance_check)
BURNISH_MAKER(contact_forces_check)
BURNISH_MAKER(contact_width_check)
BURNISH_MAKER(pressure_check)
BURNISH_MAKER(overlap_check)
BURNISH_MAKER(tool_overlap_check)
BURNISH_MAKER(folding_check)
BURNISH_MAKER(strain_check)
BURNISH_MAKER(distortion_check)
BURNISH_MAKER(yield_check)
BURNISH_MAKER(volume_check)
BURNISH_MAKER(locking_check)
BURNISH_MAKER(energy_check)
// statements, ALGORITHMS.md 17
BURNISH_MAKER(surface_end)
BURNISH_MAKER(coarse_mesh)
BURNISH_MAKER(largest_values)
BURNISH_MAKER(unused_yield)
BURNISH_MAKER(unused_friction)
BURNISH_MAKER(unmoved_coordinates)
BURNISH_MAKER(idle_mesh)
BURNISH_MAKER(short_steps)
BURNISH_MAKER(symmetric_scene)
BURNISH_MAKER(small_strains)
BURNISH_MAKER(left_out)
#undef BURNISH_MAKER

} // namespace burnish

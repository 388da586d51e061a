#pragma once
// The list of all observers: one line for each, in the order in which they look.
#include "diagnosis/observer.hpp"

/// What explains failed steps, the first cause first; the last three warn of the same in accepted ones.
#define BURNISH_CAUSES(X)                                                                                    \
  X(unseen_force)                                                                                            \
  X(program_jump)                                                                                            \
  X(pulling_force)                                                                                           \
  X(unheld_workpiece)                                                                                        \
  X(incompressible_workpiece)                                                                                \
  X(force_over_way)                                                                                          \
  X(last_equilibrium)                                                                                        \
  X(end_of_tool)                                                                                             \
  X(few_nodes_hold)                                                                                          \
  X(tight_radius)                                                                                            \
  X(tools_compete)                                                                                           \
  X(hold_carries)

/// Self-checks, ALGORITHMS.md 16.
#define BURNISH_CHECKS(X)                                                                                    \
  X(balance_check)                                                                                           \
  X(contact_forces_check)                                                                                    \
  X(contact_width_check)                                                                                     \
  X(pressure_check)                                                                                          \
  X(overlap_check)                                                                                           \
  X(tool_overlap_check)                                                                                      \
  X(folding_check)                                                                                           \
  X(strain_check)                                                                                            \
  X(distortion_check)                                                                                        \
  X(yield_check)                                                                                             \
  X(volume_check)                                                                                            \
  X(locking_check)                                                                                           \
  X(energy_check)                                                                                            \
  X(turning_check)                                                                                           \
  X(turning_slip)                                                                                            \
  X(smooth_vertices)                                                                                         \
  X(held_across)                                                                                             \
  X(wedged_friction)                                                                                         \
  X(damage_under_force)                                                                                      \
  X(jumps)

/// Statements, ALGORITHMS.md 17.
#define BURNISH_STATEMENTS(X)                                                                                \
  X(surface_end)                                                                                             \
  X(coarse_mesh)                                                                                             \
  X(largest_values)                                                                                          \
  X(unused_yield)                                                                                            \
  X(unused_friction)                                                                                         \
  X(idle_tools)                                                                                              \
  X(unmoved_coordinates)                                                                                     \
  X(idle_mesh)                                                                                               \
  X(short_steps)                                                                                             \
  X(symmetric_scene)                                                                                         \
  X(small_strains)                                                                                           \
  X(left_out)

namespace burnish {

template <int Dim> ObserverList<Dim> causes();
/// Checks and statements.
template <int Dim> ObserverList<Dim> checks();

#define BURNISH_MAKER(NAME) template <int Dim> std::unique_ptr<Observer<Dim>> NAME();
BURNISH_CAUSES(BURNISH_MAKER)
BURNISH_CHECKS(BURNISH_MAKER)
BURNISH_STATEMENTS(BURNISH_MAKER)
#undef BURNISH_MAKER

} // namespace burnish

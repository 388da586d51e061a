#pragma once
// Vertices without a weight that may hold or not: they do what they did when the step began (METHOD.md 3.19).
#include "contact/window_solver.hpp"

namespace burnish {

/// At a solution with its states in order: every vertex without a weight that holds and did not when the step began, or the other way
/// round, goes back, if that is in order as well with the tools where they are. What decides is then the start and the end of a
/// step, not the way of its iteration, nor whether motions or forces drive it. Without ties; in the plane nothing is done.
/// @param problem of the converged iterate; its prescriptions are not asked
/// @param state   of that iterate; changed where a vertex goes back
/// @returns whether one does: the iteration goes on
template <int Dim> bool return_vertices(const WindowProblem<Dim>& problem, ContactState<Dim>& state);

} // namespace burnish

#pragma once
// Contact states inside an iteration: primal-dual active set on the dense block (ALGORITHMS.md 5.3).
#include "contact/window_solver.hpp"

namespace burnish {

/// Solves the block, tests every window node, changes states and repeats until nothing changes.
template <int Dim> WindowSolution<Dim> solve_window(const WindowProblem<Dim>& problem);

} // namespace burnish

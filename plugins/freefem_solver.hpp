#pragma once
// A sparse solver of FreeFEM behind the core's interface.
#include "plugin.hpp"
#include "solver/sparse_solver.hpp"

namespace burnish {

/// Whether the solver reads one triangle of a symmetric matrix: CHOLMOD and its like. @param name in capitals
bool takes_triangle(const std::string& name);

/// The solver of that name, of which nothing reaches the screen. UMFPACK is asked without FreeFEM between, since it solves many
/// right-hand sides at once then. @param name in capitals, see known_solver; @param stack of the script
std::unique_ptr<SparseSolver> freefem_solver(const std::string& name, Stack stack);

} // namespace burnish

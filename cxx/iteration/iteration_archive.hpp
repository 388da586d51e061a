#pragma once
// What an iteration keeps from step to step, into a file and from one (base/archive.hpp).
#include "base/archive.hpp"
#include "iteration/corrector.hpp"
#include "iteration/predictor.hpp"

namespace burnish {

template <class Archive, int Dim> void serialize(Archive& archive, NodeBlockMatrix<Dim>& value) {
  BURNISH_MEMBERS(value, num_nodes, row_start, col, value_);
}
template <class Archive, int Dim> void serialize(Archive& archive, StepHistory<Dim>& value) {
  BURNISH_MEMBERS(value, du, dq, q_old, dt, own);
}
template <class Archive> void serialize(Archive& archive, LoadMemory& value) {
  BURNISH_MEMBERS(value, scale, tools, rounding);
}
template <class Archive> void serialize(Archive& archive, IterationCounts& value) {
  BURNISH_MEMBERS(value, iterations, factorizations, solves, analyses, backtracks, condensations,
                  factor_entries, factorization_seconds, condensation_seconds, solve_seconds);
}

/// A factor goes by its matrix, where that was kept, and is made anew by Corrector::restore; without it there is none.
template <class Archive, int Dim> void save(Archive& archive, const FactorMemory<Dim>& memory) {
  auto& [window, tangent, age] = memory;
  const bool given = tangent && tangent->matrix.num_nodes > 0;
  archive(window, age, given);
  if (!given) return;
  const auto& [solver, by_columns, nodes, flexibility, added, slip_stiffness, matrix, solved] = *tangent;
  archive(by_columns, nodes, added, slip_stiffness, matrix, solver ? solver->solved_columns() : solved);
}
template <class Archive, int Dim> void load(Archive& archive, FactorMemory<Dim>& memory) {
  auto& [window, tangent, age] = memory;
  bool given = false;
  archive(window, age, given);
  tangent = nullptr;
  if (!given) return;
  tangent = std::make_shared<FactoredTangent<Dim>>();
  auto& [solver, by_columns, nodes, flexibility, added, slip_stiffness, matrix, solved] = *tangent;
  archive(by_columns, nodes, added, slip_stiffness, matrix, solved);
}

} // namespace burnish

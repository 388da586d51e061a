#pragma once
// What a factorization can end with; none of these is bad input, the caller decides what to do.

namespace burnish {

enum class FactorStatus {
  OK,
  NOT_POSITIVE_DEFINITE, ///< a symmetric factorization met a pivot that is not positive
  SINGULAR,              ///< an unsymmetric factorization met a zero pivot
  BORDER_TOO_LARGE       ///< more nonsymmetric rows than BorderedSolver is allowed to treat densely
};

} // namespace burnish

#pragma once
// How friction enters the matrix of an iteration (METHOD.md 3.21). The residual is the same with all of them.
#include "contact/tangential_law.hpp"

namespace burnish {

enum class FrictionTangent {
  CONSISTENT, ///< the derivative of the residual: nonsymmetric
  LAGGED,     ///< friction on the right-hand side, at the last normal force: symmetric
};

/// The cone that a sliding node is linearized with: of LAGGED constant, its limit at the force N.
inline ConeTangent seen_by(FrictionTangent tangent, const ConeTangent& cone, double N) {
  return tangent == FrictionTangent::LAGGED ? ConeTangent{0, cone.slope * N + cone.constant} : cone;
}

} // namespace burnish

#pragma once
// Whether a matrix of node blocks is symmetric, as the factor of the tangent needs it.
#include "solver/node_block_matrix.hpp"

namespace burnish {

/// @param tolerance largest |k_ij - k_ji| allowed, over the largest |k_ij|
/// @throws std::invalid_argument "where: ..." naming the worst pair of entries, node and component of both, and the
///         asymmetry over the largest entry
template <int Dim> void require_symmetric(const NodeBlockMatrix<Dim>& K, double tolerance, const char* where);

} // namespace burnish

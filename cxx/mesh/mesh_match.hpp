#pragma once
// Whether two things are of one mesh: a material and a contact, a matrix and a contact.
#include "mesh/mesh.hpp"
#include <cstdint>

namespace burnish {

/// @param of_a, of_b what the meshes belong to, "the material"
/// @throws std::invalid_argument "where: ..." unless both have the same nodes at the same places, the same elements, and
///         are both plane or both axisymmetric; names the first difference
template <int Dim>
void require_same_mesh(const Mesh<Dim>& a, const std::string& of_a, const Mesh<Dim>& b,
                       const std::string& of_b, const char* where);

/// A number that differs for meshes that require_same_mesh tells apart (but for one in 2^64).
template <int Dim> std::uint64_t mesh_fingerprint(const Mesh<Dim>& mesh);

/// Number of pairs of different nodes (row_start, col: a pattern of nodes, sorted rows) that no element joins, and of
/// all pairs of different nodes in the pattern.
struct ForeignPairs {
  long foreign = 0, all = 0;
};
template <int Dim>
ForeignPairs foreign_pairs(const Mesh<Dim>& mesh, const std::vector<int>& row_start,
                           const std::vector<int>& col);

} // namespace burnish

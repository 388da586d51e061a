#include "contact/matrix_check.hpp"
#include "base/error.hpp"
#include "mesh/mesh_match.hpp"
#include <cstring>
#include <deque>

namespace burnish {

namespace {

constexpr std::size_t KEPT = 16; // tangents remembered
constexpr double FOREIGN = 0.5;  // share of pairs that no element joins, from which on K is of another mesh

struct Known {
  std::uint64_t matrix, mesh;
  bool axisymmetric;
};
std::deque<Known>& known() {
  static std::deque<Known> list;
  return list;
}

// The same for one triangle of a symmetric matrix stored as a whole: the lower one counts, in any order.
template <int Dim> std::uint64_t values_of(const NodeBlockMatrix<Dim>& K) {
  std::uint64_t sum = 0;
  for (int row = 0; row < K.num_nodes; ++row)
    for (int k = K.row_start[row]; k < K.row_start[row + 1] && K.col[k] <= row; ++k)
      for (int i = 0; i < Dim * Dim; ++i) {
        if (K.col[k] == row && i % Dim > i / Dim) continue; // above the diagonal
        std::uint64_t word = 0;
        const double value = K.block(k)[i] + 0.;
        std::memcpy(&word, &value, sizeof word);
        word = (word ^ (static_cast<std::uint64_t>(K.col[k]) << 32) ^
                static_cast<std::uint64_t>(Dim * Dim * row + i)) *
               0x9E3779B97F4A7C15u;
        sum += value == 0 ? 0 : word ^ (word >> 29);
      }
  return sum;
}

} // namespace

template <int Dim>
void note_tangent(const NodeBlockMatrix<Dim>& K, std::uint64_t fingerprint, bool axisymmetric) {
  known().push_front({values_of(K), fingerprint, axisymmetric});
  if (known().size() > KEPT) known().pop_back();
}

template <int Dim>
void MatrixCheck::require_of(const Mesh<Dim>& mesh, const NodeBlockMatrix<Dim>& K, const char* where) {
  if (m_fingerprint == 0) m_fingerprint = mesh_fingerprint(mesh);
  if (!known().empty()) {
    const std::uint64_t values = values_of(K);
    for (const Known& one : known()) {
      if (one.matrix != values || one.mesh == m_fingerprint) continue;
      if (one.axisymmetric == mesh.axisymmetric)
        fail(where, "K is the tangent of a material on another mesh than the contact's");
      fail(where, std::string("K is the tangent of ") +
                      (one.axisymmetric ? "an axisymmetric material, the contact is plane"
                                        : "a plane material, the contact is axisymmetric"));
    }
  }
  if (K.row_start == m_row_start && K.col == m_col) return;
  const ForeignPairs pairs = foreign_pairs(mesh, K.row_start, K.col);
  if (static_cast<double>(pairs.foreign) > FOREIGN * static_cast<double>(pairs.all))
    fail(where, "K is of another mesh: " + std::to_string(pairs.foreign) + " of its " +
                    std::to_string(pairs.all) +
                    " pairs of nodes are of no common element, allowed half of them");
  m_row_start = K.row_start;
  m_col = K.col;
}

template void note_tangent<2>(const NodeBlockMatrix<2>&, std::uint64_t, bool);
template void note_tangent<3>(const NodeBlockMatrix<3>&, std::uint64_t, bool);
template void MatrixCheck::require_of<2>(const Mesh<2>&, const NodeBlockMatrix<2>&, const char*);
template void MatrixCheck::require_of<3>(const Mesh<3>&, const NodeBlockMatrix<3>&, const char*);

} // namespace burnish

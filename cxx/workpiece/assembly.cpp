#include "workpiece/assembly.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include <limits>

namespace burnish {
namespace {

// Hoop = 1: with the gradients N/R out of the plane, of the radial component. Mirror: sign of the transposed blocks.
template <int Hoop, int Mirror, int Dim>
void add_point(const Discretization<Dim>& mesh, int point, const std::uint16_t* slot,
               const PiolaTangent<Dim>& A, NodeBlockMatrix<Dim>& matrix) {
  using Block = Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>;
  const int nodes = mesh.nodes_per_element, *node = mesh.element(point / mesh.points_per_element);
  const double *gradient = mesh.gradients(point), *shape = mesh.shapes(point);
  const double inverse_radius = Hoop ? mesh.inverse_radius(point) : 0;
  for (int b = 0; b < nodes; ++b) {
    // A times the gradients that the components k of node b cause; then the block (i,k) of pair (a,b)
    const Eigen::Map<const Vector<Dim>> grad_b(gradient + Dim * b);
    Eigen::Matrix<double, Dim * Dim + Hoop, Dim> column;
    for (int k = 0; k < Dim; ++k)
      column.col(k).noalias() = A.template block<Dim * Dim + Hoop, Dim>(0, Dim * k) * grad_b;
    if constexpr (Hoop) column.col(0) += shape[b] * inverse_radius * A.template rightCols<1>();
    for (int a = 0; a <= b; ++a) {
      const Eigen::Map<const Vector<Dim>> grad_a(gradient + Dim * a);
      Block block;
      for (int i = 0; i < Dim; ++i)
        block.row(i).noalias() = grad_a.transpose() * column.template middleRows<Dim>(Dim * i);
      if constexpr (Hoop) block.row(0) += shape[a] * inverse_radius * column.template bottomRows<1>();
      Eigen::Map<Block>(matrix.block(matrix.row_start[node[a]] + slot[a * nodes + b])) += block;
      if (a == b) continue;
      Eigen::Map<Block> mirrored(matrix.block(matrix.row_start[node[b]] + slot[b * nodes + a]));
      if constexpr (Mirror > 0)
        mirrored += block.transpose();
      else
        mirrored -= block.transpose();
    }
  }
}

} // namespace

template <int Dim>
void add_force(const Discretization<Dim>& mesh, int point, const Gradient<Dim>& P, Eigen::VectorXd& force) {
  const int* node = mesh.element(point / mesh.points_per_element);
  const double* gradient = mesh.gradients(point);
  const Tensor<Dim> in_mesh = mesh.weight[point] * mesh_part<Dim>(P);
  for (int a = 0; a < mesh.nodes_per_element; ++a)
    Eigen::Map<Vector<Dim>>(force.data() + Eigen::Index{Dim} * node[a]).noalias() +=
        in_mesh * Eigen::Map<const Vector<Dim>>(gradient + Dim * a);
  if constexpr (PointTraits<Dim>::has_hoop) {
    if (!mesh.axisymmetric) return;
    const double hoop = mesh.weight[point] * P[ZZ] * mesh.inverse_radius(point);
    for (int a = 0; a < mesh.nodes_per_element; ++a)
      force[Eigen::Index{Dim} * node[a]] += hoop * mesh.shapes(point)[a];
  }
}

template <int Dim> TangentAssembly<Dim>::TangentAssembly(const Discretization<Dim>& mesh) {
  const int nodes = mesh.nodes_per_element;
  m_pattern = pattern_from_elements<Dim>(mesh.num_nodes, nodes, mesh.connectivity);
  m_pattern.value = std::vector<double>();
  const std::vector<int>& start = m_pattern.row_start;
  for (int i = 0; i < mesh.num_nodes; ++i)
    if (const int most = std::numeric_limits<std::uint16_t>::max(); start[i + 1] - start[i] > most)
      fail("TangentAssembly", sentence("nodes in elements with node ", i, " = ", start[i + 1] - start[i],
                                       ", expected at most ", most));
  m_slot.reserve(mesh.connectivity.size() * nodes);
  for (int e = 0; e < mesh.num_elements; ++e) {
    const int* node = mesh.element(e);
    for (int a = 0; a < nodes; ++a)
      for (int b = 0; b < nodes; ++b)
        m_slot.push_back(static_cast<std::uint16_t>(m_pattern.find(node[a], node[b]) - start[node[a]]));
  }
}

template <int Dim> bool TangentAssembly<Dim>::fits(const NodeBlockMatrix<Dim>& matrix) const {
  return matrix.row_start == m_pattern.row_start && matrix.col == m_pattern.col;
}

template <int Dim>
template <int Mirror>
void TangentAssembly<Dim>::add_mirrored(const Discretization<Dim>& mesh, int point,
                                        const PiolaTangent<Dim>& A, NodeBlockMatrix<Dim>& matrix) const {
  const int nodes = mesh.nodes_per_element, element = point / mesh.points_per_element;
  const std::uint16_t* slot = m_slot.data() + static_cast<std::size_t>(element) * nodes * nodes;
  const PiolaTangent<Dim> weighted = mesh.weight[point] * A;
  if constexpr (PointTraits<Dim>::has_hoop) {
    if (mesh.axisymmetric) return add_point<1, Mirror>(mesh, point, slot, weighted, matrix);
  }
  add_point<0, Mirror>(mesh, point, slot, weighted, matrix);
}

template <int Dim>
void TangentAssembly<Dim>::add(const Discretization<Dim>& mesh, int point, const PiolaTangent<Dim>& A,
                               NodeBlockMatrix<Dim>& matrix) const {
  add_mirrored<1>(mesh, point, A, matrix);
}

template <int Dim>
void TangentAssembly<Dim>::add_antisymmetric(const Discretization<Dim>& mesh, int point,
                                             const PiolaTangent<Dim>& A, NodeBlockMatrix<Dim>& matrix) const {
  add_mirrored<-1>(mesh, point, A, matrix);
}

template void add_force<2>(const Discretization<2>&, int, const Gradient<2>&, Eigen::VectorXd&);
template void add_force<3>(const Discretization<3>&, int, const Gradient<3>&, Eigen::VectorXd&);
template class TangentAssembly<2>;
template class TangentAssembly<3>;

} // namespace burnish

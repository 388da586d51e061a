#include "workpiece/element_division.hpp"
#include "parallel/ranks.hpp"
#include <algorithm>
#include <numeric>

namespace burnish {
namespace {

// Along which axis the body is longest.
template <int Dim> int longest_axis(const Discretization<Dim>& mesh) {
  const Eigen::Map<const Eigen::Matrix<double, Dim, Eigen::Dynamic>> X(mesh.X.data(), Dim, mesh.num_nodes);
  Eigen::Index axis = 0;
  (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).maxCoeff(&axis);
  return static_cast<int>(axis);
}

} // namespace

template <int Dim>
ElementDivision<Dim>::ElementDivision(const Discretization<Dim>& mesh)
    : m_divided(burnish::divided(mesh.num_dofs(), Dim)), m_num_elements(mesh.num_elements),
      m_points_per_element(mesh.points_per_element) {
  if (m_divided) divide_nodes(mesh);
}

// Slices across the longest axis, with as many nodes each.
template <int Dim> void ElementDivision<Dim>::divide_nodes(const Discretization<Dim>& mesh) {
  const int axis = longest_axis(mesh);
  m_nodes.resize(mesh.num_nodes);
  std::iota(m_nodes.begin(), m_nodes.end(), 0);
  std::stable_sort(m_nodes.begin(), m_nodes.end(), [&](int a, int b) {
    return mesh.X[static_cast<std::size_t>(Dim) * a + axis] <
           mesh.X[static_cast<std::size_t>(Dim) * b + axis];
  });
  const std::size_t size = ranks().size(), rank = ranks().rank();
  for (std::size_t r = 0; r <= size; ++r) m_of_rank.push_back(m_nodes.size() * r / size);
  for (std::size_t r = 0; r < size; ++r) // the arrays are walked through forwards
    std::sort(m_nodes.begin() + m_of_rank[r], m_nodes.begin() + m_of_rank[r + 1]);
  std::vector<char> mine(mesh.num_nodes, 0);
  for (std::size_t k = m_of_rank[rank]; k < m_of_rank[rank + 1]; ++k) mine[m_nodes[k]] = 1;
  for (int e = 0; e < mesh.num_elements; ++e) {
    const int* node = mesh.element(e);
    if (std::any_of(node, node + mesh.nodes_per_element, [&](int a) { return mine[a] != 0; }))
      m_elements.push_back(e);
  }
}

// place(node): where the numbers of a row begin, and how many there are.
template <int Dim>
template <class Place>
void ElementDivision<Dim>::share(double* values, Place&& place) const {
  const int size = ranks().size(), rank = ranks().rank();
  std::vector<std::size_t> start(1, 0);
  for (int r = 0; r < size; ++r) {
    start.push_back(start.back());
    for (std::size_t k = m_of_rank[r]; k < m_of_rank[r + 1]; ++k) start.back() += place(m_nodes[k]).second;
  }
  std::vector<double> numbers(start.back());
  double* to = numbers.data() + start[rank];
  for (std::size_t k = m_of_rank[rank]; k < m_of_rank[rank + 1]; ++k) {
    const auto [first, count] = place(m_nodes[k]);
    to = std::copy(values + first, values + first + count, to);
  }
  ranks().gather(numbers.data(), start);
  const double* from = numbers.data();
  for (const int node : m_nodes) {
    const auto [first, count] = place(node);
    std::copy(from, from + count, values + first);
    from += count;
  }
}

template <int Dim> void ElementDivision<Dim>::share_rows(Eigen::VectorXd& values) const {
  if (!m_divided) return;
  share(values.data(), [](int node) {
    return std::pair<std::size_t, std::size_t>(static_cast<std::size_t>(Dim) * node, Dim);
  });
}
template <int Dim> void ElementDivision<Dim>::share_rows(NodeBlockMatrix<Dim>& matrix) const {
  if (!m_divided) return;
  share(matrix.value.data(), [&](int node) {
    const std::size_t first = matrix.row_start[node], end = matrix.row_start[node + 1];
    return std::pair<std::size_t, std::size_t>(first * Dim * Dim, (end - first) * Dim * Dim);
  });
}

template class ElementDivision<2>;
template class ElementDivision<3>;

} // namespace burnish

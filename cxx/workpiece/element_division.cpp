#include "workpiece/element_division.hpp"
#include "parallel/ranks.hpp"
#include <algorithm>
#include <limits>
#include <numeric>

namespace burnish {
namespace {

constexpr int ELEMENTS_AT_A_TIME = 64; // of a batch

// What a point hands on besides its arrays of doubles: whether it flowed, and its trial.
constexpr int EXTRA = 3;

template <int Dim> int numbers_of_point(const WorkpieceState<Dim>& state) {
  const auto internal = static_cast<int>(state.internal.size() / state.plastic.size());
  return num_gradient<Dim> + 2 * num_stress<Dim> + internal + EXTRA;
}

// Calls f(first, count) for each array of doubles of a point.
template <int Dim, class F> void for_arrays(WorkpieceState<Dim>& state, std::size_t p, F&& f) {
  const std::size_t internal = state.internal.size() / state.plastic.size();
  f(state.F.data() + p * num_gradient<Dim>, num_gradient<Dim>);
  f(state.stress.data() + p * num_stress<Dim>, num_stress<Dim>);
  f(state.strain_increment.data() + p * num_stress<Dim>, num_stress<Dim>);
  f(state.internal.data() + p * internal, internal);
}

template <int Dim>
double* put_point(WorkpieceState<Dim>& state, const PointTrial& trial, std::size_t p, double* to) {
  for_arrays<Dim>(state, p, [&](const double* from, std::size_t n) { to = std::copy(from, from + n, to); });
  for (const int number : {static_cast<int>(state.plastic[p]), trial.substeps, trial.used}) *to++ = number;
  return to;
}

template <int Dim>
const double* take_point(WorkpieceState<Dim>& state, PointTrial& trial, std::size_t p, const double* from) {
  for_arrays<Dim>(state, p, [&](double* to, std::size_t n) {
    std::copy(from, from + n, to);
    from += n;
  });
  state.plastic[p] = *from++ != 0;
  trial.substeps = static_cast<int>(*from++);
  trial.used = static_cast<int>(*from++);
  return from;
}

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

template <int Dim> int ElementDivision<Dim>::num_batches() const {
  return (m_num_elements + ELEMENTS_AT_A_TIME - 1) / ELEMENTS_AT_A_TIME;
}
template <int Dim> int ElementDivision<Dim>::first_element(int batch) const {
  return std::min(batch * ELEMENTS_AT_A_TIME, m_num_elements);
}
template <int Dim> bool ElementDivision<Dim>::is_mine(int batch) const {
  return batch % ranks().size() == ranks().rank();
}

template <int Dim>
void ElementDivision<Dim>::share_points(WorkpieceState<Dim>& state, std::vector<PointTrial>& trial) const {
  const int size = ranks().size(), rank = ranks().rank(), batches = num_batches();
  const auto for_points_of = [&](int r, auto&& f) {
    for (int b = r; b < batches; b += size)
      for (int p = first_element(b) * m_points_per_element; p < first_element(b + 1) * m_points_per_element;
           ++p)
        f(static_cast<std::size_t>(p));
  };
  std::vector<std::size_t> start(1, 0);
  for (int r = 0; r < size; ++r) {
    start.push_back(start.back());
    for_points_of(r, [&](std::size_t) { start.back() += numbers_of_point(state); });
  }
  std::vector<double> numbers(start.back());
  double* to = numbers.data() + start[rank];
  for_points_of(rank, [&](std::size_t p) { to = put_point(state, trial[p], p, to); });
  ranks().gather(numbers.data(), start);
  for (int r = 0; r < size; ++r) {
    const double* from = numbers.data() + start[r];
    if (r != rank) for_points_of(r, [&](std::size_t p) { from = take_point(state, trial[p], p, from); });
  }
}

template <int Dim>
int ElementDivision<Dim>::share_failure(int& point, UpdateStatus& status, double& value) const {
  constexpr long none = std::numeric_limits<int>::max();
  const long first = ranks().least(point < 0 ? none : point);
  if (first == none) return -1;
  const int batch = static_cast<int>(first) / m_points_per_element / ELEMENTS_AT_A_TIME;
  const int of = batch % ranks().size();
  point = static_cast<int>(first);
  ranks().broadcast(&status, sizeof status, of);
  ranks().broadcast(&value, sizeof value, of);
  return batch;
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

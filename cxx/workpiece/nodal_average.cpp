#include "workpiece/nodal_average.hpp"
#include "base/decompositions.hpp"
#include "base/error.hpp"
#include <algorithm>

namespace burnish {
namespace {

/// Points count as lying in one plane below this determinant of the mean normal matrix, free of units.
constexpr double FLAT = 1e-4;

// Elements of every node.
template <int Dim> std::vector<std::vector<int>> elements_of_nodes(const Discretization<Dim>& d) {
  std::vector<std::vector<int>> elements(d.num_nodes);
  for (int e = 0; e < d.num_elements; ++e)
    for (int a = 0; a < d.nodes_per_element; ++a) elements[d.element(e)[a]].push_back(e);
  return elements;
}

} // namespace

template <int Dim> NodalFit<Dim>::NodalFit(const Discretization<Dim>& d) : m_num_values(d.num_points()) {
  const auto patches = elements_of_nodes(d);
  m_begin.push_back(0);
  m_has_fit.reserve(patches.size());
  for (int n = 0; n < d.num_nodes; ++n) {
    for (const int e : patches[n])
      for (int q = 0; q < d.points_per_element; ++q) m_point.push_back(e * d.points_per_element + q);
    m_begin.push_back(static_cast<int>(m_point.size()));
    add_weights(d, n);
  }
}

// Weights of the value at the node of the linear least-squares fit over the points of its patch.
template <int Dim> void NodalFit<Dim>::add_weights(const Discretization<Dim>& d, int n) {
  constexpr int terms = Dim + 1; // 1 and the coordinates
  using Row = Eigen::Matrix<double, terms, 1>;
  const int first = m_begin[n], count = m_begin[n + 1] - first;
  std::vector<Row> row(count);
  double size2 = 0; // makes the fit free of units
  for (int i = 0; i < count; ++i) {
    const Vector<Dim> r =
        Eigen::Map<const Vector<Dim>>(d.point.data() + Dim * m_point[first + i]) - d.node(n);
    size2 = std::max(size2, r.squaredNorm());
    row[i] << 1, r;
  }
  Eigen::Matrix<double, terms, terms> normal = Eigen::Matrix<double, terms, terms>::Zero();
  for (Row& r : row) {
    r.template tail<Dim>() /= std::sqrt(size2);
    normal += r * r.transpose();
  }
  double flat = FLAT;
  for (int k = 0; k < terms; ++k) flat *= count;
  m_has_fit.push_back(count >= terms && std::abs(normal.determinant()) >= flat);
  const Row weights = m_has_fit.back() ? first_of_inverse(normal) : Row(Row::Unit(0) / count);
  for (const Row& r : row) m_weight.push_back(weights.dot(r));
}

template <int Dim> double NodalFit<Dim>::at(int n, const Eigen::VectorXd& values, bool within) const {
  const int first = m_begin[n], count = m_begin[n + 1] - first;
  double fitted = 0, mean = 0, low = values[m_point[first]], high = low;
  for (int i = first; i < first + count; ++i) {
    const double value = values[m_point[i]];
    fitted += m_weight[i] * value;
    mean += value / count;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!m_has_fit[n]) return mean;
  if (!within) return fitted;
  return count > Dim + 1 ? std::clamp(fitted, low, high) : mean;
}

template <int Dim>
Eigen::VectorXd NodalFit<Dim>::operator()(const Eigen::VectorXd& values, bool within) const {
  require(values.size() == m_num_values, "nodal_average", "number of values", values.size(),
          "one per quadrature point");
  const int nodes = static_cast<int>(m_begin.size()) - 1;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(nodes);
  for (int n = 0; n < nodes; ++n)
    if (m_begin[n] < m_begin[n + 1]) result[n] = at(n, values, within);
  return result;
}

template class NodalFit<2>;
template class NodalFit<3>;

template <int Dim>
Eigen::VectorXd nodal_average(const Discretization<Dim>& d, const Eigen::VectorXd& values, bool within) {
  return NodalFit<Dim>(d)(values, within);
}

template Eigen::VectorXd nodal_average<2>(const Discretization<2>&, const Eigen::VectorXd&, bool);
template Eigen::VectorXd nodal_average<3>(const Discretization<3>&, const Eigen::VectorXd&, bool);

Eigen::VectorXd vertex_values(const Discretization<2>& mesh, const Eigen::VectorXd& values, double share) {
  const char* where = "vertex_values";
  require(values.size() == mesh.num_points(), where, "size of values", values.size(), "num_points");
  if (mesh.points_per_element == 1) return values;
  require(mesh.points_per_element == 3, where, "points_per_element", mesh.points_per_element, "1 or 3");
  // vertices lie twice as far from the centroid as the inner points, and opposite to the middles of the edges
  const double factor = mesh.axisymmetric ? 2 * share : -2 * share;
  Eigen::VectorXd result(values.size());
  for (Eigen::Index e = 0; e < values.size(); e += 3) {
    const double middle = values.segment<3>(e).mean();
    result.segment<3>(e) = middle + factor * (values.segment<3>(e).array() - middle);
  }
  return result;
}

} // namespace burnish

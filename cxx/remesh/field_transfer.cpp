#include "remesh/field_transfer.hpp"
#include "base/decompositions.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "mesh/point_tree.hpp"
#include "mesh/simplex.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double NEAR = 0.1;   // over the size of the elements: points nearer than that count alike
constexpr double BEYOND = 0.5; // of the range of the points: how far a value may lie outside it
constexpr double FAR = 3;      // sizes of an element: a place this far from all points is outside the body
constexpr double THIN = 1e-6;  // determinant of the normal matrix over its trace: below, a mean is taken

template <int Dim> std::vector<Vector<Dim>> rows_of(const std::vector<double>& places) {
  std::vector<Vector<Dim>> rows(places.size() / Dim);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = Eigen::Map<const Vector<Dim>>(&places[Dim * i]);
  return rows;
}

template <int Dim> double size_of(const Mesh<Dim>& mesh, int element) {
  double size = 0;
  for (int v = 1; v <= Dim; ++v)
    size = std::max(size, (mesh.node(mesh.element(element)[v]) - mesh.node(mesh.element(element)[0])).norm());
  return size;
}

// Elements around every vertex.
template <int Dim> std::vector<std::vector<int>> elements_around(const Mesh<Dim>& mesh) {
  std::vector<std::vector<int>> around(mesh.num_nodes);
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int v = 0; v <= Dim; ++v) around[mesh.element(e)[v]].push_back(e);
  return around;
}

// Points of an element and of those that share a vertex with it.
template <int Dim>
std::vector<int> patch_of(const Discretization<Dim>& mesh, const std::vector<std::vector<int>>& around,
                          int element) {
  std::vector<int> elements;
  for (int v = 0; v <= Dim; ++v) {
    const std::vector<int>& more = around[mesh.element(element)[v]];
    elements.insert(elements.end(), more.begin(), more.end());
  }
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  std::vector<int> points;
  for (const int e : elements)
    for (int q = 0; q < mesh.points_per_element; ++q) points.push_back(e * mesh.points_per_element + q);
  return points;
}

template <int Dim> Barycentric<Dim> barycentric(const Mesh<Dim>& mesh, int element, const Vector<Dim>& x) {
  const int* nodes = mesh.element(element);
  Tensor<Dim> edges;
  for (int c = 0; c < Dim; ++c) edges.col(c) = mesh.node(nodes[c + 1]) - mesh.node(nodes[0]);
  Barycentric<Dim> l;
  l.template tail<Dim>() = edges.inverse() * (x - mesh.node(nodes[0]));
  l[0] = 1 - l.template tail<Dim>().sum();
  return l;
}

} // namespace

template <int Dim>
FieldTransfer<Dim>::FieldTransfer(const Discretization<Dim>& from, const std::vector<Vector<Dim>>& to)
    : m_num_values(from.num_points()) {
  const PointTree<Dim> tree(rows_of<Dim>(from.point));
  const auto around = elements_around<Dim>(from);
  m_begin.push_back(0);
  for (const Vector<Dim>& x : to) {
    const auto found = tree.nearest(x);
    const int element = found.index / from.points_per_element;
    const double size = size_of<Dim>(from, element), distance = std::sqrt(found.squared_distance);
    if (!(distance <= FAR * size))
      fail("remesh", sentence("the new mesh has a place at ", place_text(x), ", ", distance,
                              " from the workpiece as it is now, expected a mesh of the deformed workpiece"));
    m_nearest.push_back(found.index);
    add_weights(from, x, patch_of(from, around, element));
  }
}

template <int Dim>
void FieldTransfer<Dim>::add_weights(const Discretization<Dim>& from, const Vector<Dim>& x,
                                     const std::vector<int>& patch) {
  using Row = Eigen::Matrix<double, Dim + 1, 1>;
  const double size = size_of<Dim>(from, m_nearest.back() / from.points_per_element);
  std::vector<Row> rows;
  std::vector<double> weights;
  Eigen::Matrix<double, Dim + 1, Dim + 1> normal = Eigen::Matrix<double, Dim + 1, Dim + 1>::Zero();
  double sum = 0;
  for (const int p : patch) {
    Row row;
    row << 1, (Eigen::Map<const Vector<Dim>>(from.point.data() + Dim * p) - x) / size;
    const double r2 = row.template tail<Dim>().squaredNorm() + NEAR * NEAR;
    rows.push_back(row);
    weights.push_back(1 / (r2 * r2));
    normal += weights.back() * row * row.transpose();
    sum += weights.back();
  }
  const bool fits = normal.determinant() > THIN * std::pow(normal.trace() / (Dim + 1), Dim + 1);
  const Row solved = fits ? first_of_inverse(normal) : Row(Row::Unit(0) / sum);
  for (std::size_t i = 0; i < rows.size(); ++i) m_weight.push_back(weights[i] * rows[i].dot(solved));
  m_point.insert(m_point.end(), patch.begin(), patch.end());
  m_begin.push_back(static_cast<int>(m_point.size()));
}

template <int Dim> Eigen::VectorXd FieldTransfer<Dim>::operator()(const Eigen::VectorXd& values) const {
  require(values.size() == m_num_values, "remesh", "number of values", values.size(),
          "one per quadrature point");
  Eigen::VectorXd result(static_cast<Eigen::Index>(m_nearest.size()));
  for (std::size_t k = 0; k < m_nearest.size(); ++k) {
    double fitted = 0, low = values[m_point[m_begin[k]]], high = low;
    for (int i = m_begin[k]; i < m_begin[k + 1]; ++i) {
      const double value = values[m_point[i]];
      fitted += m_weight[i] * value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    const double more = BEYOND * (high - low);
    result[static_cast<Eigen::Index>(k)] = std::clamp(fitted, low - more, high + more);
  }
  return result;
}

template class FieldTransfer<2>;
template class FieldTransfer<3>;

template <int Dim>
Eigen::VectorXd nodal_transfer(const Mesh<Dim>& from, const Eigen::VectorXd& values,
                               const std::vector<Vector<Dim>>& to) {
  std::vector<Vector<Dim>> middles(from.num_elements);
  for (int e = 0; e < from.num_elements; ++e) {
    middles[e].setZero();
    for (int v = 0; v <= Dim; ++v) middles[e] += from.node(from.element(e)[v]) / (Dim + 1);
  }
  const PointTree<Dim> tree(middles);
  const auto around = elements_around<Dim>(from);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(Dim * to.size()));
  for (std::size_t k = 0; k < to.size(); ++k) {
    int best = tree.nearest(to[k]).index;
    double inside = barycentric<Dim>(from, best, to[k]).minCoeff();
    const int start = best;
    for (int v = 0; v <= Dim && inside < 0; ++v)
      for (const int e : around[from.element(start)[v]]) {
        const double least = barycentric<Dim>(from, e, to[k]).minCoeff();
        if (least > inside) best = e, inside = least;
      }
    const Barycentric<Dim> l = barycentric<Dim>(from, best, to[k]).cwiseMax(-0.5).cwiseMin(1.5);
    for (int v = 0; v <= Dim; ++v)
      result.segment<Dim>(static_cast<Eigen::Index>(Dim * k)) +=
          l[v] * values.segment<Dim>(Eigen::Index{Dim} * from.element(best)[v]);
  }
  return result;
}

template Eigen::VectorXd nodal_transfer<2>(const Mesh<2>&, const Eigen::VectorXd&,
                                           const std::vector<Vector<2>>&);
template Eigen::VectorXd nodal_transfer<3>(const Mesh<3>&, const Eigen::VectorXd&,
                                           const std::vector<Vector<3>>&);

} // namespace burnish

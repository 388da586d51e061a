#include "workpiece/nodal_average.hpp"
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

// Linear least-squares fit over the points of a patch, evaluated at the node.
template <int Dim>
double fit_at_node(const Discretization<Dim>& d, const std::vector<int>& patch, const Vector<Dim>& node,
                   const Eigen::VectorXd& values, bool within) {
  constexpr int terms = Dim + 1; // 1 and the coordinates
  using Row = Eigen::Matrix<double, terms, 1>;
  Eigen::Matrix<double, terms, terms> normal = Eigen::Matrix<double, terms, terms>::Zero();
  Row right = Row::Zero();
  double low = values[patch[0] * d.points_per_element], high = low, size2 = 0;
  int count = 0;
  for (const int pass : {0, 1}) // the size of the patch first, to make the fit free of units
    for (const int e : patch)
      for (int q = 0; q < d.points_per_element; ++q) {
        const int p = e * d.points_per_element + q;
        const Vector<Dim> r = Eigen::Map<const Vector<Dim>>(d.point.data() + Dim * p) - node;
        if (pass == 0) {
          size2 = std::max(size2, r.squaredNorm());
          continue;
        }
        Row row;
        row << 1, r / std::sqrt(size2);
        normal += row * row.transpose();
        right += values[p] * row;
        low = std::min(low, values[p]);
        high = std::max(high, values[p]);
        ++count;
      }
  const double mean = right[0] / count;
  double flat = FLAT;
  for (int k = 0; k < terms; ++k) flat *= count;
  if (count < terms + (within ? 1 : 0) || std::abs(normal.determinant()) < flat) return mean;
  const double fitted = normal.ldlt().solve(right)[0];
  return within ? std::clamp(fitted, low, high) : fitted;
}

} // namespace

template <int Dim>
Eigen::VectorXd nodal_average(const Discretization<Dim>& d, const Eigen::VectorXd& values, bool within) {
  require(values.size() == d.num_points(), "nodal_average", "number of values", values.size(),
          "one per quadrature point");
  const auto patches = elements_of_nodes(d);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(d.num_nodes);
  for (int n = 0; n < d.num_nodes; ++n)
    if (!patches[n].empty()) result[n] = fit_at_node<Dim>(d, patches[n], d.node(n), values, within);
  return result;
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

#include "contact/body_view.hpp"
#include "base/decompositions.hpp"
#include "mesh/point_tree.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

template <int Dim> double candidate_spacing(const Eigen::VectorXd& X, const std::vector<int>& candidates) {
  std::vector<Vector<Dim>> places;
  for (const int node : candidates) places.push_back(X.segment<Dim>(Eigen::Index{Dim} * node));
  const PointTree<Dim> tree(places);
  std::vector<double> nearest;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto other = tree.nearest(places[i], static_cast<int>(i));
    if (other.index >= 0 && other.squared_distance > 0) nearest.push_back(std::sqrt(other.squared_distance));
  }
  if (nearest.empty()) return 0;
  std::nth_element(nearest.begin(), nearest.begin() + nearest.size() / 2, nearest.end());
  return nearest[nearest.size() / 2];
}

template <int Dim> bool constrains_rigid_motions(const BodyView<Dim>& body) {
  constexpr int modes = Dim + Dim * (Dim - 1) / 2;
  constexpr double least = 1e-9; // smallest eigenvalue of the modes' Gram matrix, over the largest one
  using Motion = Eigen::Matrix<double, modes, 1>;
  const Eigen::Map<const Eigen::Matrix<double, Dim, Eigen::Dynamic>> nodes(body.X.data(), Dim,
                                                                           body.X.size() / Dim);
  const Vector<Dim> middle = nodes.rowwise().mean();
  const double size = (nodes.colwise() - middle).norm() / std::sqrt(static_cast<double>(nodes.cols()));
  Eigen::Matrix<double, modes, modes> gram = Eigen::Matrix<double, modes, modes>::Zero();
  for (Eigen::Index d = 0; d < body.X.size(); ++d) {
    if (!body.fixed[d]) continue;
    const Vector<Dim> lever = (nodes.col(d / Dim) - middle) / size;
    Motion motion = Motion::Zero(); // of this component in every mode
    motion[d % Dim] = 1;
    for (int i = 0, mode = Dim; i < Dim; ++i)
      for (int j = i + 1; j < Dim; ++j, ++mode)
        motion[mode] = d % Dim == i ? -lever[j] : d % Dim == j ? lever[i] : 0;
    gram += motion * motion.transpose();
  }
  const Eigen::VectorXd eigenvalues = symmetric_eigen(gram).values;
  return eigenvalues[0] > least * std::max(eigenvalues[modes - 1], 1.);
}

template struct BodyView<2>;
template struct BodyView<3>;
template bool constrains_rigid_motions<2>(const BodyView<2>&);
template bool constrains_rigid_motions<3>(const BodyView<3>&);
template double candidate_spacing<2>(const Eigen::VectorXd&, const std::vector<int>&);
template double candidate_spacing<3>(const Eigen::VectorXd&, const std::vector<int>&);

} // namespace burnish

#include "contact/body_view.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

double candidate_spacing(const Eigen::VectorXd& X, int dim, const std::vector<int>& candidates) {
  std::vector<double> nearest;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    double best = -1;
    for (std::size_t j = 0; j < candidates.size(); ++j) {
      if (i == j) continue;
      const double d =
          (X.segment(dim * candidates[i], dim) - X.segment(dim * candidates[j], dim)).squaredNorm();
      if (best < 0 || d < best) best = d;
    }
    if (best > 0) nearest.push_back(std::sqrt(best));
  }
  if (nearest.empty()) return 0;
  std::nth_element(nearest.begin(), nearest.begin() + nearest.size() / 2, nearest.end());
  return nearest[nearest.size() / 2];
}

template <int Dim> bool holds_rigid_motions(const BodyView<Dim>& body) {
  static_assert(Dim == 2, "in space there are three rotations");
  const Eigen::Map<const Eigen::Matrix2Xd> nodes(body.X.data(), 2, body.X.size() / 2);
  const Vector<2> middle = nodes.rowwise().mean();
  const double size = (nodes.colwise() - middle).norm() / std::sqrt(static_cast<double>(nodes.cols()));
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  for (Eigen::Index d = 0; d < body.X.size(); ++d) {
    if (!body.fixed[d]) continue;
    const Vector<2> lever = (nodes.col(d / 2) - middle) / size;
    const Eigen::Vector3d motion(d % 2 == 0, d % 2 == 1, d % 2 == 0 ? -lever.y() : lever.x());
    gram += motion * motion.transpose();
  }
  const Eigen::Vector3d eigenvalues = gram.selfadjointView<Eigen::Lower>().eigenvalues();
  return eigenvalues[0] > 1e-9 * std::max(eigenvalues[2], 1.);
}

template struct BodyView<2>;
template bool holds_rigid_motions<2>(const BodyView<2>&);

} // namespace burnish

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

template struct BodyView<2>;

} // namespace burnish

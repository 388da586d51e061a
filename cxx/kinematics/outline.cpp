#include "kinematics/outline.hpp"
#include "base/error.hpp"

namespace burnish {

template <int Dim> std::vector<Vector<Dim>> outline(const Tool<Dim>& tool, const Eigen::VectorXd& q, long n) {
  require(n >= 2 && n <= 1000000, "outline", "number of points", n, "2 to 1000000");
  const auto pose = tool.coordinates().pose(q);
  std::vector<Vector<Dim>> points;
  for (const auto& place : tool.surface().outline(static_cast<int>(n)))
    points.push_back(tool.position(pose, place));
  return points;
}

template std::vector<Vector<2>> outline<2>(const Tool<2>&, const Eigen::VectorXd&, long);
template std::vector<Vector<3>> outline<3>(const Tool<3>&, const Eigen::VectorXd&, long);

} // namespace burnish

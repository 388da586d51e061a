#include "kinematics/tool_foot.hpp"

namespace burnish {

template <int Dim>
std::vector<ToolFoot<Dim>> tool_feet(const Tool<Dim>& tool, const Eigen::VectorXd& q,
                                     const std::vector<Vector<Dim>>& points) {
  const auto pose = tool.coordinates().pose(q);
  const Param<Dim> no_hint = Param<Dim>::Zero();
  std::vector<ToolFoot<Dim>> feet;
  feet.reserve(points.size());
  for (const auto& x : points) {
    const SurfaceFoot<Dim> foot = tool.foot(pose, x, no_hint);
    const SurfaceFrame<Dim> local = tool.surface().frame(foot.place);
    feet.push_back({tool.position(pose, foot.place), pose.R * local.n, pose.R * local.E, local.B / pose.size,
                    foot.gap, foot.on_end});
  }
  return feet;
}

template std::vector<ToolFoot<2>> tool_feet<2>(const Tool<2>&, const Eigen::VectorXd&,
                                               const std::vector<Vector<2>>&);
template std::vector<ToolFoot<3>> tool_feet<3>(const Tool<3>&, const Eigen::VectorXd&,
                                               const std::vector<Vector<3>>&);

} // namespace burnish

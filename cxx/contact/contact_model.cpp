#include "contact/contact_model.hpp"

namespace burnish {

const char* name_of(NodeState state) {
  switch (state) {
  case NodeState::FREE:
    return "free";
  case NodeState::TOUCHED:
    return "touched";
  case NodeState::SLIDING:
    return "sliding";
  case NodeState::STICKING:
    return "sticking";
  case NodeState::LEAVING:
    return "leaving";
  case NodeState::RECEDING:
    return "receding";
  }
  return "?";
}

template <int Dim> std::vector<Pose<Dim>> ContactModel<Dim>::poses(const Eigen::VectorXd& q) const {
  std::vector<Pose<Dim>> result;
  result.reserve(tools.size());
  for (std::size_t i = 0; i < tools.size(); ++i)
    result.push_back(tools[i]->coordinates().pose(tool_q(q, static_cast<int>(i))));
  return result;
}

template <int Dim> bool ContactModel<Dim>::symmetric() const {
  for (const auto& law : friction)
    if (!law->frictionless()) return false;
  return true;
}

template <int Dim>
NearestTool<Dim> nearest_tool(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses,
                              const Vector<Dim>& x, const ContactNode<Dim>& near) {
  NearestTool<Dim> best;
  for (std::size_t i = 0; i < model.tools.size(); ++i) {
    const int t = static_cast<int>(i);
    const Param<Dim> branch = near.tool == t ? near.s : Param<Dim>::Zero();
    const ClosestPoint<Dim> foot = model.tools[i]->closest_point(poses[i], x, branch);
    if (best.tool < 0 || foot.gap < best.foot.gap) best = {t, foot};
  }
  return best;
}

template struct ContactModel<2>;
template NearestTool<2> nearest_tool<2>(const ContactModel<2>&, const std::vector<Pose<2>>&, const Vector<2>&,
                                        const ContactNode<2>&);

} // namespace burnish

#include "contact/contact_model.hpp"
#include <limits>

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

template <int Dim> std::string ContactModel<Dim>::coordinate(int k) const {
  std::size_t tool = 0;
  while (tool + 1 < tools.size() && k >= first[tool + 1]) ++tool;
  const std::string& name = tools[tool]->coordinates().names()[static_cast<std::size_t>(k - first[tool])];
  return "coordinate \"" + name + "\" of tool \"" + tools[tool]->name() + "\"";
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

template <int Dim> bool ContactModel<Dim>::is_held(int candidate) const {
  if (held.empty()) return false;
  for (const bool component : held[candidate])
    if (component) return true;
  return false;
}

template <int Dim> bool ContactModel<Dim>::may_touch(int candidate, int tool) const {
  return reach.empty() || reach[tool].empty() || reach[tool][candidate];
}

template <int Dim> const FrictionLaw& ContactModel<Dim>::law(int candidate, int tool) const {
  static const NoFriction none;
  return is_held(candidate) ? static_cast<const FrictionLaw&>(none) : *friction[tool];
}

template <int Dim>
NearestTool<Dim> nearest_tool(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses,
                              const Vector<Dim>& x, const ContactNode<Dim>& near, int candidate) {
  NearestTool<Dim> best{-1, {Param<Dim>::Zero(), std::numeric_limits<double>::infinity(), true}};
  for (std::size_t i = 0; i < model.tools.size(); ++i) {
    const int t = static_cast<int>(i);
    if (candidate >= 0 && !model.may_touch(candidate, t)) continue;
    const Param<Dim> branch = near.tool == t ? near.s : Param<Dim>::Zero();
    const ClosestPoint<Dim> foot = model.tools[i]->closest_point(poses[i], x, branch);
    if (best.tool < 0 || foot.gap < best.foot.gap) best = {t, foot};
  }
  return best;
}

template <int Dim>
Vector<Dim> normal_lift(const ContactModel<Dim>& model, int candidate, const Vector<Dim>& n) {
  if (!model.is_held(candidate)) return n;
  Vector<Dim> free = n;
  for (int c = 0; c < Dim; ++c)
    if (model.held[candidate][c]) free[c] = 0;
  const double share = free.squaredNorm();
  return share > 1e-4 ? Vector<Dim>(free / share) : Vector<Dim>::Zero();
}

template <int Dim>
NodalForce<Dim> nodal_force(const ContactModel<Dim>& model, int candidate, const SurfacePoint<Dim>& p,
                            const Vector<Dim>& R) {
  if (!model.is_held(candidate)) return {R, R.dot(p.n), R.dot(p.x_s.col(0).normalized())};
  const double N = R.dot(normal_lift(model, candidate, p.n));
  return {N * p.n, N, 0};
}

template <int Dim>
Vector<Dim> offset_to(const ContactModel<Dim>& model, int candidate, const SurfacePoint<Dim>& p,
                      const Vector<Dim>& x) {
  if (!model.is_held(candidate)) return p.x - x;
  return p.n.dot(p.x - x) * normal_lift(model, candidate, p.n);
}

template struct ContactModel<2>;
template NearestTool<2> nearest_tool<2>(const ContactModel<2>&, const std::vector<Pose<2>>&, const Vector<2>&,
                                        const ContactNode<2>&, int);
template NodalForce<2> nodal_force<2>(const ContactModel<2>&, int, const SurfacePoint<2>&, const Vector<2>&);
template Vector<2> normal_lift<2>(const ContactModel<2>&, int, const Vector<2>&);
template Vector<2> offset_to<2>(const ContactModel<2>&, int, const SurfacePoint<2>&, const Vector<2>&);

} // namespace burnish

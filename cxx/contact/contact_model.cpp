#include "contact/contact_model.hpp"
#include <algorithm>
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

template <int Dim> const Coupling* ContactModel<Dim>::coupling_of(int k) const {
  for (const Coupling& coupling : couplings)
    if (coupling.dependent == k) return &coupling;
  return nullptr;
}

template <int Dim> std::vector<int> ContactModel<Dim>::followers(int k) const {
  std::vector<int> result;
  for (const Coupling& coupling : couplings) {
    const std::vector<int>& arguments = coupling.formula->arguments();
    if (std::find(arguments.begin(), arguments.end(), k) != arguments.end())
      result.push_back(coupling.dependent);
  }
  return result;
}

template <int Dim> int ContactModel<Dim>::tool_of(int k) const {
  int tool = 0;
  while (tool + 1 < static_cast<int>(tools.size()) && k >= first[tool + 1]) ++tool;
  return tool;
}

template <int Dim> std::string ContactModel<Dim>::coordinate(int k) const {
  const auto tool = static_cast<std::size_t>(tool_of(k));
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
  for (const auto& law : laws)
    if (!law.frictionless()) return false;
  return true;
}

template <int Dim> bool ContactModel<Dim>::is_constrained(int candidate) const {
  if (constrained.empty()) return false;
  for (const bool component : constrained[candidate])
    if (component) return true;
  return false;
}

template <int Dim> bool ContactModel<Dim>::may_touch(int candidate, int tool) const {
  return reach.empty() || reach[tool].empty() || reach[tool][candidate];
}

template <int Dim> bool ContactModel<Dim>::can_slip(int candidate) const {
  if (constrained.empty()) return true;
  const auto& given = constrained[candidate];
  return std::count(given.begin(), given.end(), true) < Dim - 1;
}

template <int Dim> const TangentialLaw<Dim>& ContactModel<Dim>::law(int candidate, int tool) const {
  static const TangentialLaw<Dim> none(std::make_shared<NoFriction>());
  const bool slips =
      can_slip(candidate) && (!is_weightless(candidate) || laws[tool].friction().sticks_always());
  return slips ? laws[tool] : none;
}
template <int Dim>
const TangentialLaw<Dim>& ContactModel<Dim>::law(int candidate, const ContactNode<Dim>& node) const {
  return (node.bears || node.has_ties) && can_slip(candidate) ? laws[node.tool] : law(candidate, node.tool);
}

std::vector<int> candidate_of_node(const std::vector<int>& candidates, int num_nodes) {
  std::vector<int> number(num_nodes, -1);
  for (std::size_t i = 0; i < candidates.size(); ++i) number[candidates[i]] = static_cast<int>(i);
  return number;
}

template <int Dim>
NearestTool<Dim> nearest_tool(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses,
                              const Vector<Dim>& x, const ContactNode<Dim>& near, int candidate) {
  NearestTool<Dim> best;
  for (std::size_t i = 0; i < model.tools.size(); ++i) {
    const int t = static_cast<int>(i);
    if (candidate >= 0 && !model.may_touch(candidate, t)) continue;
    const Param<Dim> hint = near.tool == t ? near.place.hint : Param<Dim>::Zero();
    const SurfaceFoot<Dim> foot = model.tools[i]->foot(poses[i], x, hint);
    if (best.tool < 0 || foot.gap < best.foot.gap) best = {t, foot};
  }
  return best;
}

template <int Dim>
ContactPoint<Dim> contact_point(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses,
                                const ContactNode<Dim>& node) {
  ContactPoint<Dim> at{model.tools[node.tool]->point(poses[node.tool], node.place), Param<Dim>::Zero()};
  const Param<Dim> direction = at.surface.E.transpose() * (poses[node.tool].R * node.slip_direction);
  const double size = direction.norm();
  if (size > 0) at.m = direction / size;
  return at;
}

template <int Dim>
Vector<Dim> admissible_normal(const ContactModel<Dim>& model, int candidate, const Vector<Dim>& n) {
  if (!model.is_constrained(candidate)) return n;
  constexpr double across = 1e-4; // squared cosine below which the supports block the node against the tool
  Vector<Dim> free = n;
  for (int c = 0; c < Dim; ++c)
    if (model.constrained[candidate][c]) free[c] = 0;
  const double part = free.squaredNorm();
  return part > across ? Vector<Dim>(free / part) : Vector<Dim>::Zero();
}

template <int Dim>
NodalForce<Dim> nodal_force(const ContactModel<Dim>& model, int candidate, const SurfacePoint<Dim>& p,
                            const Vector<Dim>& R) {
  if (!model.is_constrained(candidate)) return {R, {R.dot(p.n), p.E.transpose() * R}};
  const double N = R.dot(admissible_normal(model, candidate, p.n));
  if (!model.can_slip(candidate)) return {N * p.n, {N, Param<Dim>::Zero()}};
  const Param<Dim> T = slip_space(model, candidate, p) * (p.E.transpose() * R);
  return {N * p.n + p.E * T, {N, T}};
}

template <int Dim>
Curvature<Dim> slip_space(const ContactModel<Dim>& model, int candidate, const SurfacePoint<Dim>& p) {
  if (!model.is_constrained(candidate)) return Curvature<Dim>::Identity();
  Curvature<Dim> projector = Curvature<Dim>::Zero();
  if (!model.can_slip(candidate)) return projector;
  for (int c = 0; c < Dim; ++c)
    if (model.constrained[candidate][c]) {
      const Param<Dim> across = p.E.row(c).transpose();
      if (!across.isZero(1e-12))
        projector = Curvature<Dim>::Identity() - across * across.transpose() / across.squaredNorm();
    }
  return projector;
}

template <int Dim>
Vector<Dim> offset_to(const ContactModel<Dim>& model, int candidate, const SurfacePoint<Dim>& p,
                      const Vector<Dim>& x) {
  if (!model.is_constrained(candidate)) return p.x - x;
  const Vector<Dim> d = p.x - x, along = p.n.dot(d) * admissible_normal(model, candidate, p.n);
  if (!model.can_slip(candidate)) return along;
  return along + p.E * (slip_space(model, candidate, p) * (p.E.transpose() * d));
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template struct ContactModel<Dim>;                                                                         \
  template NearestTool<Dim> nearest_tool<Dim>(const ContactModel<Dim>&, const std::vector<Pose<Dim>>&,       \
                                              const Vector<Dim>&, const ContactNode<Dim>&, int);             \
  template ContactPoint<Dim> contact_point<Dim>(const ContactModel<Dim>&, const std::vector<Pose<Dim>>&,     \
                                                const ContactNode<Dim>&);                                    \
  template Vector<Dim> admissible_normal<Dim>(const ContactModel<Dim>&, int, const Vector<Dim>&);            \
  template NodalForce<Dim> nodal_force<Dim>(const ContactModel<Dim>&, int, const SurfacePoint<Dim>&,         \
                                            const Vector<Dim>&);                                             \
  template Curvature<Dim> slip_space<Dim>(const ContactModel<Dim>&, int, const SurfacePoint<Dim>&);          \
  template Vector<Dim> offset_to<Dim>(const ContactModel<Dim>&, int, const SurfacePoint<Dim>&,               \
                                      const Vector<Dim>&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish

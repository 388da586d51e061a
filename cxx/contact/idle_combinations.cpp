#include "contact/idle_combinations.hpp"
#include "base/decompositions.hpp"
#include "contact/driving_force.hpp"
#include "contact/tool_support.hpp"

namespace burnish {
namespace {

// Square of the motion that the nodes see over that of the tool, mean over the nodes: a tool on a patch of 1e-6 of its size.
constexpr double UNSEEN = 1e-14;

// Coordinates of a tool that their own force alone decides, and which is zero.
std::vector<int> idle_candidates(const ContactModel<3>& model, const PrescribedValues& prescribed, int tool,
                                 const Eigen::VectorXd& drive) {
  std::vector<int> result;
  for (int k = model.first[tool]; k < model.first[tool + 1]; ++k)
    if (!prescribed.is_motion[k] && !prescribed.is_held(k) && !model.coupling_of(k) &&
        model.followers(k).empty() && drive[k] == 0)
      result.push_back(k - model.first[tool]);
  return result;
}

// Sum over the nodes of the motion's part that they see, squared, by the coordinates; empty: no contact.
Eigen::MatrixXd seen_motions(const ContactModel<3>& model, const ContactState<3>& state, const Pose<3>& pose,
                             int tool) {
  Eigen::MatrixXd sum;
  double nodes = 0;
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const ContactNode<3>& node = state.nodes[i];
    if (!in_contact(node.state) || node.tool != tool) continue;
    const int candidate = static_cast<int>(i);
    const auto p = model.tools[tool]->point(pose, node.place);
    const bool normal_only = model.law(candidate, node).frictionless();
    const Eigen::MatrixXd motion =
        normal_only ? Eigen::MatrixXd(p.n.transpose() * p.x_q) : Eigen::MatrixXd(p.x_q);
    if (sum.size() == 0) sum = Eigen::MatrixXd::Zero(motion.cols(), motion.cols());
    sum += motion.transpose() * motion;
    ++nodes;
  }
  return nodes > 0 ? Eigen::MatrixXd(sum / nodes) : sum;
}

// The motion of the tool by each coordinate: of its frame's origin, and of places one length away [length per unit].
Eigen::VectorXd motions_of_tool(const Pose<3>& pose, double length) {
  Eigen::VectorXd size(static_cast<Eigen::Index>(pose.origin_q.size()));
  for (Eigen::Index k = 0; k < size.size(); ++k)
    size[k] = std::hypot(pose.origin_q[k].norm(),
                         length * turn_and_growth(pose, static_cast<std::size_t>(k)).norm());
  return size.unaryExpr([](double s) { return s > 0 ? s : 1.; });
}

// The coordinates of the candidates that stand for the motions which are not seen.
std::vector<int> unseen(Eigen::MatrixXd seen, const Eigen::VectorXd& size, std::vector<int> candidates) {
  std::vector<int> result;
  seen = (size.cwiseInverse().asDiagonal() * seen * size.cwiseInverse().asDiagonal()).eval();
  while (!candidates.empty()) {
    const SymmetricEigen eigen = symmetric_eigen(seen(candidates, candidates));
    if (eigen.values[0] > UNSEEN) break;
    Eigen::Index most = 0;
    eigen.vectors.col(0).cwiseAbs().maxCoeff(&most);
    result.push_back(candidates[static_cast<std::size_t>(most)]);
    candidates.erase(candidates.begin() + most);
  }
  return result;
}

} // namespace

template <>
std::vector<int> idle_combinations<2>(const ContactModel<2>&, const PrescribedValues&,
                                      const ContactState<2>&) {
  return {};
}

template <>
std::vector<int> idle_combinations<3>(const ContactModel<3>& model, const PrescribedValues& prescribed,
                                      const ContactState<3>& state) {
  std::vector<int> result;
  const auto poses = model.poses(state.q);
  Eigen::VectorXd drive;
  for (int tool = 0; tool < static_cast<int>(model.tools.size()); ++tool) {
    if (drive.size() == 0) drive = driving_force(model, prescribed, state.q).value;
    const std::vector<int> candidates = idle_candidates(model, prescribed, tool, drive);
    if (candidates.empty()) continue;
    const Eigen::MatrixXd seen = seen_motions(model, state, poses[tool], tool);
    if (seen.size() == 0) continue;
    const double length = model.tools[tool]->surface().length_scale();
    for (const int k : unseen(seen, motions_of_tool(poses[tool], length), candidates))
      result.push_back(model.first[tool] + k);
  }
  return result;
}

template <int Dim>
PrescribedValues with_idle_given(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                                 const ContactState<Dim>& state, const Eigen::VectorXd& resting) {
  std::vector<int> idle = idle_coordinates(model, prescribed, state);
  for (const int k : idle_combinations(model, prescribed, state)) idle.push_back(k);
  PrescribedValues result = prescribed;
  for (const int k : idle) {
    result.is_motion[k] = 1;
    result.value[k] = resting[k];
  }
  return result;
}

template PrescribedValues with_idle_given<2>(const ContactModel<2>&, const PrescribedValues&,
                                             const ContactState<2>&, const Eigen::VectorXd&);
template PrescribedValues with_idle_given<3>(const ContactModel<3>&, const PrescribedValues&,
                                             const ContactState<3>&, const Eigen::VectorXd&);

} // namespace burnish

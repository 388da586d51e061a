#include "diagnosis/before/floating_check.hpp"
#include "base/decompositions.hpp"
#include "base/error.hpp"
#include "contact/rigid_modes.hpp"
#include "contact/tool_support.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double NONE = 1e-10; // eigenvalue over the largest: squares of motions that nothing resists
constexpr double SHARE = 1e-3; // of the workpiece or of a coordinate in the motion: less is rounding

// Coordinates that follow a motion without a change of their force.
template <int Dim>
std::vector<int> following(const ContactSetup<Dim>& setup, const PrescribedValues& prescribed) {
  const auto& model = setup.model();
  std::vector<int> free;
  for (int k = 0; k < model.num_coordinates(); ++k)
    if (!prescribed.is_motion[k] && !prescribed.is_held(k) && !model.coupling_of(k) &&
        model.followers(k).empty())
      free.push_back(k);
  return free;
}

// Squares of the motion of the contact nodes and their neighbors against their tools, by rigid motions and coordinates.
template <int Dim>
Eigen::MatrixXd resistance(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                           const std::vector<int>& free, const RigidModes<Dim>& modes,
                           const Eigen::VectorXd& u) {
  constexpr int count = RigidModes<Dim>::count;
  const auto& model = setup.model();
  const auto poses = model.poses(state.q);
  const Eigen::Index n = count + static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    const auto p = model.tools[node.tool]->point(poses[node.tool], node.place);
    const bool slips = model.law(static_cast<int>(i), node.tool).frictionless();
    std::vector<int> near{static_cast<int>(i)}; // under a load the contact has a width
    if (!model.neighbors.empty())
      near.insert(near.end(), model.neighbors[i].begin(), model.neighbors[i].end());
    for (const int candidate : near) {
      Eigen::MatrixXd apart = Eigen::MatrixXd::Zero(Dim, n);
      apart.leftCols(count) = modes(setup.body().position(u, setup.candidates()[candidate]));
      for (std::size_t f = 0; f < free.size(); ++f)
        if (model.tool_of(free[f]) == node.tool)
          apart.col(count + static_cast<Eigen::Index>(f)) = -p.x_q.col(free[f] - model.first[node.tool]);
      const Eigen::MatrixXd seen = slips ? Eigen::MatrixXd(p.n.transpose() * apart) : apart;
      sum += seen.transpose() * seen;
    }
  }
  sum.topLeftCorner(count, count) += modes.resisted_by_supports(setup.body(), u);
  return sum;
}

} // namespace

template <int Dim>
void check_not_floating(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                        const PrescribedValues& prescribed, const Eigen::VectorXd& u) {
  constexpr int count = RigidModes<Dim>::count;
  if (constrains_rigid_motions(setup.body())) return;
  const std::vector<int> free = following(setup, prescribed);
  if (free.empty()) return;
  const auto touches = [](const auto& node) { return in_contact(node.state); };
  if (std::none_of(state.nodes.begin(), state.nodes.end(), touches)) return;
  const RigidModes<Dim> modes(setup.body(), setup.body().position(u, setup.candidates()[0]));
  Eigen::MatrixXd sum = resistance(setup, state, free, modes, u);
  Eigen::VectorXd scale = sum.diagonal().cwiseSqrt();
  scale.head(count).setConstant(scale.head(count).maxCoeff());
  for (double& s : scale)
    if (s == 0) s = 1;
  sum = scale.cwiseInverse().asDiagonal() * sum * scale.cwiseInverse().asDiagonal();
  const SymmetricEigen eigen = symmetric_eigen(sum);
  for (Eigen::Index k = 0; k < sum.rows(); ++k) {
    if (eigen.values[k] > NONE * eigen.values[sum.rows() - 1]) return;
    const Eigen::VectorXd motion = eigen.vectors.col(k);
    if (motion.head(count).norm() < SHARE) continue; // a tool alone: another check
    std::string names;
    for (std::size_t f = 0; f < free.size(); ++f)
      if (std::abs(motion[count + static_cast<Eigen::Index>(f)]) > SHARE)
        names += (names.empty() ? "" : ", ") + setup.model().coordinate(free[f]);
    if (names.empty()) continue; // the workpiece alone: the step says so if it fails
    fail("contact.begin",
         "the workpiece is not held: it can move with " + names +
             " under force, and nothing holds them: its supports (fixed=) leave it a rigid motion "
             "that no tool under motion takes; hold it, or give the coordinate a motion");
  }
}

template void check_not_floating<2>(const ContactSetup<2>&, const ContactState<2>&, const PrescribedValues&,
                                    const Eigen::VectorXd&);
template void check_not_floating<3>(const ContactSetup<3>&, const ContactState<3>&, const PrescribedValues&,
                                    const Eigen::VectorXd&);

} // namespace burnish

#include "stepping/balance.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

// Whether r is worse than the worst so far; NaN is the worst of all and stays.
bool worse(double r, const Balance& result) {
  return !(r <= result.residual) && !std::isnan(result.residual);
}

// Largest unbalanced force of the nodes that are not in contact.
template <int Dim>
void free_residual(const ContactModel<Dim>& model, const BodyView<Dim>& body, const ContactState<Dim>& state,
                   const Eigen::VectorXd& R, Balance& result) {
  std::vector<char> skip = body.fixed;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    if (in_contact(state.nodes[i].state))
      for (int c = 0; c < Dim; ++c) skip[Dim * model.candidates[i] + c] = 1;
  for (Eigen::Index d = 0; d < R.size(); ++d)
    if (!skip[d] && worse(std::abs(R[d]), result)) {
      result.residual = std::abs(R[d]);
      result.worst_dof = static_cast<int>(d);
    }
}

// Residual and state test of one node in contact.
template <int Dim>
void contact_node(const ContactModel<Dim>& model, int candidate, const ContactNode<Dim>& node,
                  const SurfacePoint<Dim>& p, const NodalForce<Dim>& force, const Vector<Dim>& x,
                  double force_tolerance, double gap_tolerance, double offset_tolerance, Balance& result) {
  const FrictionLaw& law = model.law(candidate, node.tool);
  const double length = p.x_s.col(0).norm(), N = force.N, T = force.T;
  result.friction += std::abs(T);
  result.friction_limit += law.limit(std::max(N, 0.), node.area);
  bool bad = N < -force_tolerance || offset_to(model, candidate, p, x).norm() > offset_tolerance;
  if (node.state == NodeState::SLIDING) {
    const double r = std::abs(T + node.slip_sign * law.limit(N, node.area));
    if (worse(r, result)) {
      result.residual = r;
      result.worst_dof = result.worst_coordinate = -1;
    }
    const double slip = (node.s - node.s_ref)[0] * node.slip_sign * length;
    bad = bad || (!law.frictionless() && slip < -gap_tolerance);
  } else {
    bad = bad || std::abs(T) > law.limit(std::max(N, 0.), node.area) + force_tolerance;
  }
  result.inconsistent += bad;
}

// Tool rows over their lever arms.
void tool_residual(const Program& program, const Eigen::VectorXd& lever, Balance& result) {
  const Eigen::Index nq = result.tool_force.size();
  result.tool_residual = Eigen::VectorXd::Zero(nq);
  for (Eigen::Index k = 0; k < nq; ++k) {
    if (program.is_motion[k]) continue;
    const double r = result.tool_force[k] - program.value[k];
    result.tool_residual[k] = lever[k] > 0 ? r / lever[k] : (r == 0 ? 0 : result.load + std::abs(r));
    if (worse(std::abs(result.tool_residual[k]), result)) {
      result.residual = std::abs(result.tool_residual[k]);
      result.worst_dof = -1;
      result.worst_coordinate = static_cast<int>(k);
    }
  }
}

} // namespace

template <int Dim>
Balance balance(const ContactModel<Dim>& model, const BodyView<Dim>& body, const ContactState<Dim>& state,
                const Program& program, const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                double force_tolerance, double gap_tolerance, double offset_tolerance) {
  Balance result;
  const Eigen::Index nq = model.num_coordinates();
  result.tool_force = Eigen::VectorXd::Zero(nq);
  Eigen::VectorXd lever = Eigen::VectorXd::Zero(nq);
  const auto poses = model.poses(state.q);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const ContactNode<Dim>& node = state.nodes[i];
    const Vector<Dim> x = body.position(u, model.candidates[i]);
    if (!in_contact(node.state)) {
      if (node.state == NodeState::RECEDING || node.state == NodeState::LEAVING) continue;
      const double gap = nearest_tool(model, poses, x, node, static_cast<int>(i)).foot.gap;
      result.penetration = std::max(result.penetration, -gap);
      result.inconsistent += gap < -gap_tolerance;
      continue;
    }
    const SurfacePoint<Dim> p = model.tools[node.tool]->surface(poses[node.tool], node.s);
    const NodalForce<Dim> force = nodal_force(
        model, static_cast<int>(i), p, Vector<Dim>(R.template segment<Dim>(Dim * model.candidates[i])));
    result.load += force.F.norm();
    for (Eigen::Index k = 0; k < p.x_q.cols(); ++k) {
      result.tool_force[model.first[node.tool] + k] += p.x_q.col(k).dot(force.F);
      lever[model.first[node.tool] + k] = std::max(lever[model.first[node.tool] + k], p.x_q.col(k).norm());
    }
    contact_node(model, static_cast<int>(i), node, p, force, x, force_tolerance, gap_tolerance,
                 offset_tolerance, result);
  }
  free_residual(model, body, state, R, result);
  tool_residual(program, lever, result);
  return result;
}

template Balance balance<2>(const ContactModel<2>&, const BodyView<2>&, const ContactState<2>&,
                            const Program&, const Eigen::VectorXd&, const Eigen::VectorXd&, double, double,
                            double);

} // namespace burnish

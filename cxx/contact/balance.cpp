#include "contact/balance.hpp"
#include "contact/coupling.hpp"
#include "contact/driving_force.hpp"
#include "contact/mean_slip.hpp"
#include "contact/slip_direction.hpp"
#include "contact/tied_edges.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double LIGHT = 1e-3; // contact forces below this part of the supports' are no load

// Whether r is worse than the worst so far; NaN is the worst of all and stays.
bool worse(double r, const Balance& result) {
  return !(r <= result.residual) && !std::isnan(result.residual);
}

constexpr double AROUND =
    2.2; // spacings around the contact of a light tool where free nodes are held to its tolerance

// Weights of the residuals of all mesh nodes: beside a light tool that of the tool. Empty: all 1.
template <int Dim> std::vector<double> weights_near_tools(const BalancedState<Dim>& state) {
  const BodyView<Dim>& body = state.body;
  const Eigen::VectorXd& u = state.u;
  std::vector<double> weights;
  for (int t = 0; t < static_cast<int>(state.model.tools.size()); ++t) {
    if (state.tolerance.weight(t) == 1) continue;
    std::vector<Vector<Dim>> contact;
    Vector<Dim> middle = Vector<Dim>::Zero();
    for (std::size_t i = 0; i < state.contact.nodes.size(); ++i)
      if (in_contact(state.contact.nodes[i].state) && state.contact.nodes[i].tool == t) {
        contact.push_back(body.position(u, state.model.candidates[i]));
        middle += contact.back();
      }
    if (contact.empty()) continue;
    middle /= static_cast<double>(contact.size());
    const double margin = AROUND * body.spacing;
    double radius = 0; // of all of them: most nodes lie outside of it
    for (const Vector<Dim>& place : contact) radius = std::max(radius, (place - middle).norm());
    weights.resize(static_cast<std::size_t>(u.size() / Dim), 1);
    for (std::size_t a = 0; a < weights.size(); ++a) {
      const Vector<Dim> x = body.position(u, static_cast<int>(a));
      const auto near = [&](const Vector<Dim>& place) { return (x - place).norm() <= margin; };
      if ((x - middle).norm() <= radius + margin && std::any_of(contact.begin(), contact.end(), near))
        weights[a] = std::max(weights[a], state.tolerance.weight(t));
    }
  }
  return weights;
}

// Largest unbalanced force of the nodes that are not in contact.
template <int Dim> void free_residual(const BalancedState<Dim>& state, Balance& result) {
  const std::vector<double> weights = weights_near_tools(state);
  std::vector<char> skip = state.body.fixed;
  for (std::size_t i = 0; i < state.contact.nodes.size(); ++i)
    if (in_contact(state.contact.nodes[i].state))
      for (int c = 0; c < Dim; ++c) skip[Dim * state.model.candidates[i] + c] = 1;
  for (Eigen::Index a = 0; a < state.R.size() / Dim; ++a) { // of a node the norm: the same in turned axes
    Vector<Dim> force = state.R.template segment<Dim>(Dim * a);
    for (int c = 0; c < Dim; ++c)
      if (skip[Dim * a + c]) force[c] = 0;
    const double r = force.norm() * (weights.empty() ? 1 : weights[static_cast<std::size_t>(a)]);
    if (!worse(r, result)) continue;
    int component = 0;
    force.cwiseAbs().maxCoeff(&component);
    result.residual = r;
    result.worst_dof = static_cast<int>(Dim * a) + component;
  }
}

// Sum of the forces of the supports, less what they share with tools.
template <int Dim> double support_load(const BalancedState<Dim>& state) {
  const Eigen::VectorXd& R = state.R;
  std::vector<char> shared(R.size() / Dim, 0);
  for (std::size_t i = 0; i < state.contact.nodes.size(); ++i)
    if (in_contact(state.contact.nodes[i].state)) shared[state.model.candidates[i]] = 1;
  double sum = 0;
  for (Eigen::Index a = 0; a < R.size() / Dim; ++a) {
    double square = 0;
    for (int c = 0; c < Dim && !shared[a]; ++c)
      if (state.body.fixed[Dim * a + c]) square += R[Dim * a + c] * R[Dim * a + c];
    sum += std::sqrt(square);
  }
  return sum;
}

// Residual and state test of one node in contact.
template <int Dim>
void contact_node(const BalancedState<Dim>& state, int candidate, const ContactPoint<Dim>& at, double N,
                  const DecidingForce<Dim>& deciding, Balance& result) {
  const ContactModel<Dim>& model = state.model;
  const Tolerances& tolerance = state.tolerance;
  const ContactNode<Dim>& node = state.contact.nodes[candidate];
  const Vector<Dim> x = state.body.position(state.u, model.candidates[candidate]);
  const TangentialLaw<Dim>& law = model.law(candidate, node);
  const SurfaceForce<Dim>& force = deciding.force;
  const ContactTolerance limits = tolerance.of(node.tool);
  const bool off = offset_to(model, candidate, at.surface, x).norm() > tolerance.offset;
  if (node.tied) { // its friction is part of that of its ends
    result.inconsistent += off || N < -limits.force;
    return;
  }
  const Param<Dim> slip = slip_of(model, node, at.surface.size);
  result.friction += force.T.norm();
  result.friction_limit += law.capacity(deciding);
  if (node.state == NodeState::SLIDING) {
    double r = law.sliding_residual(deciding, at.m);
    if (!model.is_constrained(candidate) && !TangentialLaw<Dim>::slips_back(slip, at.m, 0)) {
      const Param<Dim> way = mean_slip_of(model, node, at.surface.size, state.contact.fixed).way;
      r = std::max(r, direction_residual(law, deciding, at.m, way, state.contact.slip_stiffness));
    }
    r *= tolerance.weight(node.tool);
    if (worse(r, result)) {
      result.residual = r;
      result.worst_dof = result.worst_coordinate = -1;
    }
  }
  result.inconsistent += off || law.test(node.state, N, deciding, slip, at.m, limits) != Change::NONE;
}

// Motion of a tool's points with its coordinate k, for one that its drive holds without contact.
template <int Dim>
double lever_of_tool(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses, int k) {
  const auto tool = static_cast<std::size_t>(model.tool_of(k)),
             own = static_cast<std::size_t>(k - model.first[tool]);
  return point_rate(poses[tool], own, model.tools[tool]->surface().length_scale());
}

// Levers of coordinates that others follow, of those that no node in contact sees, and of those that only their drive holds.
template <int Dim>
void complete_levers(const BalancedState<Dim>& state, const std::vector<Pose<Dim>>& poses,
                     Eigen::VectorXd& lever) {
  constexpr double unseen = 1e-9; // of the tool's own lever: rounding of a turn about the only node
  const ContactModel<Dim>& model = state.model;
  for (const Coupling& coupling : model.couplings) {
    const Eigen::VectorXd slopes = slopes_of(coupling, state.contact.q);
    for (std::size_t i = 0; i < coupling.formula->arguments().size(); ++i) {
      double& own = lever[coupling.formula->arguments()[i]];
      own = std::max(own, std::abs(slopes[static_cast<Eigen::Index>(i)]) * lever[coupling.dependent]);
    }
  }
  for (Eigen::Index k = 0; k < lever.size(); ++k) {
    const double own = lever_of_tool(model, poses, static_cast<int>(k));
    if (lever[k] > 0 ? lever[k] < unseen * own : state.prescribed.is_held(k)) lever[k] = own;
  }
}

// Prescribed forces are a load of their tool.
template <int Dim>
void add_driving_loads(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                       const DrivingForce& drive, const Eigen::VectorXd& lever, Balance& result) {
  for (int k = 0; k < static_cast<int>(lever.size()); ++k) {
    if (prescribed.is_motion[k] || model.coupling_of(k) || !(lever[k] > 0)) continue;
    double& load = result.tool_load[model.tool_of(k)];
    load = std::max(load, std::abs(drive.value[k]) / lever[k]);
  }
}

// Weight of the row of a coordinate: that of its tool, or of a tool that follows it and carries more.
template <int Dim> double weight_of_row(const ContactModel<Dim>& model, const Tolerances& tolerance, int k) {
  double weight = tolerance.weight(model.tool_of(k));
  for (const int follower : model.followers(k))
    weight = std::min(weight, tolerance.weight(model.tool_of(follower)));
  return weight;
}

// Tool rows over their lever arms.
template <int Dim>
void tool_residual(const BalancedState<Dim>& state, const DrivingForce& drive, const Eigen::VectorXd& lever,
                   Balance& result) {
  const ContactModel<Dim>& model = state.model;
  const Eigen::Index nq = result.generalized_force.size();
  result.tool_residual = Eigen::VectorXd::Zero(nq);
  for (Eigen::Index k = 0; k < nq; ++k) {
    if (state.prescribed.is_motion[k] || model.coupling_of(static_cast<int>(k))) continue;
    double r = result.generalized_force[k] - drive.value[k];
    if (drive.rounding.size() > 0 && std::abs(r) <= drive.rounding[k]) r = 0;
    result.tool_residual[k] = lever[k] > 0 ? r / lever[k] : (r == 0 ? 0 : result.load + std::abs(r));
    const double weighted =
        weight_of_row(model, state.tolerance, static_cast<int>(k)) * std::abs(result.tool_residual[k]);
    if (worse(weighted, result)) {
      result.residual = weighted;
      result.worst_dof = -1;
      result.worst_coordinate = static_cast<int>(k);
    }
  }
}

} // namespace

template <int Dim> Balance balance(const BalancedState<Dim>& state) {
  const ContactModel<Dim>& model = state.model;
  const std::vector<ContactNode<Dim>>& nodes = state.contact.nodes;
  const Eigen::VectorXd& q = state.contact.q;
  Balance result;
  const Eigen::Index nq = model.num_coordinates();
  result.generalized_force = Eigen::VectorXd::Zero(nq);
  result.tool_load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.tools.size()));
  Eigen::VectorXd lever = Eigen::VectorXd::Zero(nq);
  const auto poses = model.poses(q);
  const std::vector<DecidingForce<Dim>> deciding = deciding_forces(model, state.contact, poses, state.R);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const ContactNode<Dim>& node = nodes[i];
    const int candidate = static_cast<int>(i);
    if (!in_contact(node.state)) {
      if (node.state == NodeState::RECEDING || node.state == NodeState::LEAVING) continue;
      const Vector<Dim> x = state.body.position(state.u, model.candidates[i]);
      const double gap = nearest_tool(model, poses, x, node, candidate).foot.gap;
      result.penetration = std::max(result.penetration, -gap);
      result.inconsistent += gap < -state.tolerance.gap;
      continue;
    }
    const ContactPoint<Dim> at = contact_point(model, poses, node);
    const Vector<Dim> Rn = state.R.template segment<Dim>(Dim * model.candidates[i]);
    const NodalForce<Dim> force = nodal_force(model, candidate, at.surface, Rn);
    result.load += force.F.norm();
    result.tool_load[node.tool] += force.F.norm();
    const int first = model.first[node.tool];
    for (Eigen::Index k = 0; k < at.surface.x_q.cols(); ++k) {
      result.generalized_force[first + k] += at.surface.x_q.col(k).dot(force.F);
      lever[first + k] = std::max(lever[first + k], at.surface.x_q.col(k).norm());
    }
    const double N = model.is_weightless(candidate) ? deciding[i].normal : force.part.N;
    contact_node(state, candidate, at, N, deciding[i], result);
  }
  pass_on_forces(model, q, result.generalized_force);
  complete_levers(state, poses, lever);
  const double others = support_load(state) + state.held;
  if (result.load < LIGHT * others) result.load = others;
  free_residual(state, result);
  const DrivingForce drive = driving_force(model, state.prescribed, q);
  add_driving_loads(model, state.prescribed, drive, lever, result);
  tool_residual(state, drive, lever, result);
  return result;
}

template Balance balance<2>(const BalancedState<2>&);
template Balance balance<3>(const BalancedState<3>&);

} // namespace burnish

#include "iteration/not_converged.hpp"
#include "contact/tied_edges.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

// What a residual that stays too large comes from.
template <int Dim> Residue residue_of(const LastIterate<Dim>& iterate, const LastIteration& last) {
  constexpr double nothing = 1e-8;   // depth of the load under the largest stiffness, over the spacing
  constexpr double falls = 0.5;      // ratio of the last residuals
  constexpr double exhausted = 1e-3; // part of the friction that is left
  const Balance& balance = iterate.balance.last();
  if (last.rounding > last.allowed) {
    const double place = 4 * std::numeric_limits<double>::epsilon() * iterate.body.X.cwiseAbs().maxCoeff();
    const double depth = last.load / last.rounding * place;
    return depth < nothing * iterate.body.spacing ? Residue::NO_LOAD : Residue::TOO_LARGE;
  }
  if (iterate.last_residual >= 0 && balance.residual < falls * iterate.last_residual) return Residue::FALLS;
  const bool used_up = balance.worst_coordinate >= 0 && balance.friction_limit > 0 &&
                       balance.friction > (1 - exhausted) * balance.friction_limit;
  return used_up ? Residue::FRICTION : Residue::UNKNOWN;
}

// Whether a coordinate under force goes on one way, in the last iteration and in the mean of all by a good part of its first
// increment. Where contact states go to and fro so does a tool.
template <int Dim> bool moves_on(const LastIterate<Dim>& iterate) {
  constexpr double part = 0.1;
  const Eigen::VectorXd &first = iterate.first_dq, &last = iterate.dq;
  if (iterate.unsolved > 0 || first.size() != last.size()) return false;
  for (Eigen::Index k = 0; k < last.size(); ++k) {
    const double least = part * first[k] * first[k];
    if (!iterate.prescribed.is_motion[k] && last[k] * first[k] > least &&
        iterate.way[k] * first[k] > iterate.number * least)
      return true;
  }
  return false;
}

// A node whose friction is beyond its limit if it sticks and along its slip if it slides: with friction that large a body may
// have no equilibrium near the last one. CYCLE: none.
template <int Dim>
Failure wedged_node(const ContactModel<Dim>& model, const ContactState<Dim>& state, const BodyView<Dim>& body,
                    const Eigen::VectorXd& u, const Eigen::VectorXd& R, double tolerance) {
  if (R.size() == 0 || u.size() != R.size()) return Cause::CYCLE;
  const auto poses = model.poses(state.q);
  const std::vector<DecidingForce<Dim>> deciding = deciding_forces(model, state, poses, R);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const ContactNode<Dim>& node = state.nodes[i];
    if (!in_contact(node.state) || node.tied || model.law(static_cast<int>(i), node).frictionless()) continue;
    const int candidate = static_cast<int>(i), mesh_node = model.candidates[i];
    const ContactPoint<Dim> at = contact_point(model, poses, node);
    const SurfaceForce<Dim>& part = deciding[i].force;
    const double reserve = model.law(candidate, node).reserve(deciding[i]);
    const bool wedged = sticks(node.state)
                            ? reserve < -tolerance
                            : part.N > 0 && slip_of(model, node, at.surface.size).dot(at.m) < 0;
    if (!wedged) continue;
    Failure failure(Cause::WEDGED);
    failure.node = mesh_node;
    const Vector<Dim> x = body.position(u, mesh_node);
    failure.place.assign(x.data(), x.data() + Dim);
    failure.value = part.T.norm();
    failure.allowed = part.N;
    return failure;
  }
  return Cause::CYCLE;
}

} // namespace

template <int Dim> Failure not_converged(const LastIterate<Dim>& iterate) {
  const Balance& balance = iterate.balance.last();
  const PrescribedValues& prescribed = iterate.prescribed;
  LastIteration last;
  last.number = iterate.number;
  last.inconsistent = balance.inconsistent;
  last.residual = balance.residual;
  last.allowed = iterate.balance.allowed();
  last.rounding = iterate.balance.memory().rounding;
  last.load = iterate.balance.scale();
  last.lagged = iterate.options.friction_tangent != FrictionTangent::CONSISTENT;
  Failure failure(Cause::NO_BALANCE);
  if (last.residual > last.allowed) {
    last.residue = residue_of(iterate, last);
    last.moves_on = last.rounding <= last.allowed && moves_on(iterate);
  } else if (balance.friction_limit > 0 &&
             std::count(prescribed.is_motion.begin(), prescribed.is_motion.end(), 0) > 0 &&
             balance.friction > (1 + iterate.options.tolerance) * balance.friction_limit) {
    failure = Cause::TOO_LITTLE_FRICTION;
    failure.value = balance.friction;
    failure.allowed = balance.friction_limit;
  } else {
    failure = wedged_node(iterate.model, iterate.state, iterate.body, iterate.u, iterate.R,
                          StepBalance<Dim>::STATE_FORCE * iterate.options.tolerance * last.load);
  }
  failure.last = last;
  return failure;
}

template Failure not_converged<2>(const LastIterate<2>&);
template Failure not_converged<3>(const LastIterate<3>&);

} // namespace burnish

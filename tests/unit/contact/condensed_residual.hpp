#pragma once
// The condensed residual of METHOD.md 3.1, written down once more for the tests, and its derivative by
// finite differences.
#include "contact/condensation.hpp"
#include "unit/finite_difference.hpp"
#include <functional>

namespace burnish::test {

/// Names of the unknowns of a condensed system: a free node, a slip, a coordinate; given ones are left out.
enum class Unknown { FREE, SLIP, COORDINATE, GIVEN };

inline std::vector<Unknown> unknowns(const ContactModel<2>& model, const ContactState<2>& state,
                                     const PrescribedValues& prescribed, const BodyView<2>& body) {
  std::vector<Unknown> kind(body.X.size() + model.num_coordinates(), Unknown::FREE);
  for (Eigen::Index d = 0; d < body.X.size(); ++d)
    if (body.fixed[d]) kind[d] = Unknown::GIVEN;
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    if (!in_contact(state.nodes[i].state)) continue;
    const int dof = 2 * model.candidates[i];
    kind[dof] = state.nodes[i].state == NodeState::SLIDING ? Unknown::SLIP : Unknown::GIVEN;
    kind[dof + 1] = Unknown::GIVEN;
  }
  for (int k = 0; k < model.num_coordinates(); ++k)
    kind[body.X.size() + k] = prescribed.is_motion[k] ? Unknown::GIVEN : Unknown::COORDINATE;
  return kind;
}

using Force = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Displacement and states after a change z of the condensed unknowns; contact nodes on their tools.
inline void moved(const ContactModel<2>& model, const BodyView<2>& body, const Eigen::VectorXd& z,
                  ContactState<2>& state, Eigen::VectorXd& u) {
  const auto before = model.poses(state.q);
  state.q += z.tail(state.q.size());
  const Eigen::VectorXd u0 = u;
  u += z.head(u.size());
  const auto poses = model.poses(state.q);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    ContactNode<2>& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    const int dof = 2 * model.candidates[i];
    const Tool<2>& tool = *model.tools[node.tool];
    if (node.state == NodeState::SLIDING)
      node.place = tool.surface().moved(node.place, Param<2>(z[dof] / before[node.tool].size));
    u.segment<2>(dof) = tool.position(poses[node.tool], node.place) - body.X.segment<2>(dof);
  }
}

/// Residual of every unknown after a change z of the unknowns: R of free nodes, E.F + m g(N) of
/// sliding ones, sum of X_k.F for coordinates (the applied forces are not subtracted), 0 for given unknowns.
inline Eigen::VectorXd condensed_residual(const ContactModel<2>& model, const BodyView<2>& body,
                                          const Force& force, const Eigen::VectorXd& z, ContactState<2> state,
                                          Eigen::VectorXd u) {
  moved(model, body, z, state, u);
  const Eigen::VectorXd R = force(u);
  Eigen::VectorXd r = Eigen::VectorXd::Zero(z.size());
  r.head(u.size()) = R;
  const auto poses = model.poses(state.q);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const ContactNode<2>& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    const int dof = 2 * model.candidates[i];
    const ContactPoint<2> at = contact_point(model, poses, node);
    const SurfacePoint<2>& p = at.surface;
    const Vector<2> F = R.segment<2>(dof);
    const double g = model.laws[node.tool].friction().limit(F.dot(p.n), node.tributary_area);
    r.segment<2>(dof) = Vector<2>(F.dot(Vector<2>(p.E)) + at.m[0] * g, 0);
    if (node.state != NodeState::SLIDING) r[dof] = 0;
    r.segment(u.size() + model.first[node.tool], p.x_q.cols()) += p.x_q.transpose() * F;
  }
  return r;
}

/// Derivative of a residual of the unknowns' increment, five-point central differences; columns of given unknowns are zero.
template <class Residual>
Eigen::MatrixXd differenced(const Residual& residual, const std::vector<Unknown>& kind, double step) {
  const auto n = static_cast<Eigen::Index>(kind.size());
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    if (kind[j] != Unknown::GIVEN)
      J.col(j) =
          finite_difference([&](double t) { return residual(t * Eigen::VectorXd::Unit(n, j)); }, 0, step);
  return J;
}

/// That of the condensed residual.
inline Eigen::MatrixXd differenced(const ContactModel<2>& model, const BodyView<2>& body, const Force& force,
                                   const ContactState<2>& state, const Eigen::VectorXd& u,
                                   const std::vector<Unknown>& kind, double step) {
  return differenced(
      [&](const Eigen::VectorXd& change) { return condensed_residual(model, body, force, change, state, u); },
      kind, step);
}

inline std::vector<Eigen::Index> of_kind(const std::vector<Unknown>& kind, Unknown wanted) {
  std::vector<Eigen::Index> list;
  for (std::size_t i = 0; i < kind.size(); ++i)
    if (kind[i] == wanted) list.push_back(static_cast<Eigen::Index>(i));
  return list;
}

inline const char* name_of(Unknown kind) {
  return kind == Unknown::FREE ? "free" : kind == Unknown::SLIP ? "slip" : "coordinate";
}

/// Error of the block (rows, columns) relative to the Frobenius norm of the expected one.
inline double block_error(const Eigen::MatrixXd& computed, const Eigen::MatrixXd& expected,
                          const std::vector<Unknown>& kind, Unknown rows, Unknown columns) {
  double error = 0, size = 0;
  for (const auto i : of_kind(kind, rows))
    for (const auto j : of_kind(kind, columns)) {
      error += std::pow(computed(i, j) - expected(i, j), 2);
      size += std::pow(expected(i, j), 2);
    }
  return size > 0 ? std::sqrt(error / size) : std::sqrt(error);
}

constexpr Unknown KINDS[] = {Unknown::FREE, Unknown::SLIP, Unknown::COORDINATE};

/// Expects every block of the two matrices to agree, relative to the block's own norm.
inline void expect_blocks(const Eigen::MatrixXd& computed, const Eigen::MatrixXd& expected,
                          const std::vector<Unknown>& kind, double tolerance) {
  for (const Unknown rows : KINDS)
    for (const Unknown columns : KINDS)
      EXPECT_LE(block_error(computed, expected, kind, rows, columns), tolerance)
          << "block " << name_of(rows) << "-" << name_of(columns);
}

} // namespace burnish::test

#pragma once
// Nodes in space, all bound to one another by a potential, on a tool that is turned and shifted: what the condensed tangent is
// compared on with differences of its residual.
#include "contact/condensation.hpp"
#include "contact/slip_direction.hpp"
#include "geometry/plane_surface.hpp"
#include "geometry/simple_surfaces.hpp"
#include "kinematics/cartesian_in_space.hpp"
#include "unit/contact/spring_body.hpp"
#include "unit/finite_difference.hpp"
#include <numeric>

namespace burnish::test {

/// A plane, a cylinder, a sphere and a torus.
inline std::vector<std::shared_ptr<const Surface<3>>> four_surfaces() {
  AxisFrame axis;
  axis.base << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  axis.point = Vector<3>(0, -4, 0);
  AxisFrame ring = axis;
  ring.point.setZero();
  return {std::make_shared<PlaneSurface>(Vector<3>(0, 0, 1), Vector<3>(0, 0, 1), 1), cylinder(1.5, 8, axis),
          sphere(1.3), torus(1.2, 0.4, ring)};
}

template <int Nodes> struct BoundNodes {
  static constexpr int NODES = Nodes, DOFS = 3 * Nodes;
  const int Q; ///< number of coordinates
  ContactModel<3> model;
  BodyView<3> body;
  ContactState<3> state;
  PrescribedValues prescribed;
  NodeBlockMatrix<3> K;
  Eigen::MatrixXd stiffness;
  Eigen::VectorXd along, u = Eigen::VectorXd::Zero(DOFS), load = u;

  BoundNodes(std::shared_ptr<const Surface<3>> surface, double mu, unsigned seed,
             std::shared_ptr<const Coordinates<3>> coordinates = std::make_shared<CartesianInSpace>())
      : Q(static_cast<int>(coordinates->names().size())), m_random(seed) {
    model.candidates.resize(NODES);
    std::iota(model.candidates.begin(), model.candidates.end(), 0);
    K = pattern_from_elements<3>(NODES, NODES, model.candidates);
    const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(DOFS, DOFS, [&] { return any(); });
    stiffness = A * A.transpose() / DOFS + 0.5 * Eigen::MatrixXd::Identity(DOFS, DOFS);
    along = Eigen::VectorXd::NullaryExpr(DOFS, [&] { return any(); });
    model.tools = {std::make_shared<Tool<3>>("tool", std::move(surface), std::move(coordinates))};
    model.laws.emplace_back(make_coulomb(mu));
    model.first = {0, Q};
    body.X = Eigen::VectorXd::Zero(DOFS);
    body.fixed.assign(DOFS, 0);
    state.nodes.resize(NODES);
    state.q = Eigen::VectorXd::Zero(Q);
    state.slip_stiffness = 0.4;
    prescribed.is_motion.assign(Q, 0);
    prescribed.value = Eigen::VectorXd::Zero(Q);
  }
  double any() { return m_uniform(m_random); }
  const Surface<3>& surface() const { return model.tools[0]->surface(); }
  /// The node sticks at the foot of a point in the tool's frame.
  void touch(int i, const Vector<3>& near) {
    ContactNode<3>& node = state.nodes[i];
    node.tool = 0;
    node.state = NodeState::STICKING;
    place_at(node, surface().foot(near, Param<3>::Zero()).place);
  }
  /// It has slid there by a way in the tool's frame.
  void slide(int i, const Vector<3>& way) {
    ContactNode<3>& node = state.nodes[i];
    node.slip_origin = surface().foot(node.place.y - way, node.place.hint).place;
    make_slide(node, Vector<3>(model.laws[0].frictionless() ? Vector<3>::Zero() : way.normalized()));
  }
  Vector<3> tangent_vector(int i, const Param<3>& along_tangents) const {
    return surface().frame(state.nodes[i].place).E * along_tangents;
  }
  /// Nodes in contact where they touch, the others anywhere.
  void settle() {
    for (int i = 0; i < NODES; ++i)
      if (in_contact(state.nodes[i].state))
        u.segment<3>(3 * i) = model.tools[0]->position(model.poses(state.q)[0], state.nodes[i].place);
      else
        for (int c = 0; c < 3; ++c) u[3 * i + c] = any();
  }
  /// Load under which the first nodes are pressed by 1 and pulled along by T(i), on their tangents.
  template <class Traction> void press(int number, const Traction& T) {
    const Eigen::VectorXd own = force(u);
    for (int i = 0; i < number; ++i) {
      const SurfacePoint<3> p = model.tools[0]->point(model.poses(state.q)[0], state.nodes[i].place);
      load.segment<3>(3 * i) = p.n + p.E * T(i) - own.segment<3>(3 * i);
    }
    if (!model.laws[0].frictionless()) turn_slips(model, force(u), state);
  }
  Eigen::VectorXd force(const Eigen::VectorXd& x) const {
    return stiffness * x + 0.1 * std::pow(along.dot(x), 2) * along + load;
  }
  Eigen::MatrixXd tangent(GeometricTerms terms = GeometricTerms::COMPLETE) {
    const Eigen::MatrixXd k = stiffness + 0.2 * along.dot(u) * along * along.transpose();
    for (int a = 0; a < NODES; ++a)
      for (int b = 0; b < NODES; ++b)
        Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&K.value[9 * K.find(a, b)]) =
            k.block<3, 3>(3 * a, 3 * b);
    Condensation<3> condensation(model, body);
    return dense(condensation.condense({K, state, prescribed, prescribed, u, force(u), terms}));
  }

private:
  std::mt19937 m_random;
  std::uniform_real_distribution<double> m_uniform{-1, 1};
};

} // namespace burnish::test

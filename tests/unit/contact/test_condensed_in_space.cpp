// The condensed tangent of space against finite differences of the cone form: slips that turn, a node on a symmetry plane,
// every kind of surface.
#include "contact/condensation.hpp"
#include "contact/slip_direction.hpp"
#include "geometry/plane_surface.hpp"
#include "geometry/simple_surfaces.hpp"
#include "kinematics/cartesian_in_space.hpp"
#include "unit/contact/spring_body.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Six nodes, all bound to one another by a potential, on a tool that is turned and shifted. Nodes 0 and 1 slide, 2 sticks, 3
/// slides on a symmetry plane (u_y given), 4 and 5 are free.
struct SpaceSample {
  static constexpr int NODES = 6, DOFS = 3 * NODES;
  ContactModel<3> model;
  BodyView<3> body;
  ContactState<3> state;
  PrescribedValues prescribed;
  NodeBlockMatrix<3> K = pattern_from_elements<3>(NODES, NODES, {0, 1, 2, 3, 4, 5});
  Eigen::MatrixXd stiffness;
  Eigen::VectorXd along, u = Eigen::VectorXd::Zero(DOFS), load = u;

  SpaceSample(std::shared_ptr<const Surface<3>> surface, double mu) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto any = [&] { return uniform(random); };
    const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(DOFS, DOFS, any);
    stiffness = A * A.transpose() / DOFS + 0.5 * Eigen::MatrixXd::Identity(DOFS, DOFS);
    along = Eigen::VectorXd::NullaryExpr(DOFS, any);
    model.tools = {std::make_shared<Tool<3>>("tool", surface, std::make_shared<CartesianInSpace>())};
    model.laws.emplace_back(make_coulomb(mu));
    model.first = {0, 6};
    model.candidates = {0, 1, 2, 3, 4, 5};
    model.constrained.assign(NODES, {false, false, false});
    model.constrained[3][1] = true;
    body.X = Eigen::VectorXd::Zero(DOFS);
    body.fixed.assign(DOFS, 0);
    body.fixed[10] = 1;
    state.nodes.resize(NODES);
    state.q = Eigen::VectorXd::Zero(6);
    state.q << 0.1, 0, -0.2, 0, 0.3, 0; // in its symmetry plane
    state.slip_stiffness = 0.4;
    prescribed.is_motion.assign(6, 0);
    prescribed.value = Eigen::VectorXd::Zero(6);
    const Vector<3> above[] = {{0.2, 0.3, 2}, {-0.3, 0.4, 2.1}, {0.4, -0.2, 1.9}, {0.15, 0, 2}};
    for (int i = 0; i < 4; ++i) touch(*surface, i, above[i], Param<3>(0.05 * any(), 0.05 * any()));
    for (int d = 12; d < DOFS; ++d) u[d] = any();
    const Eigen::VectorXd own = force(u);
    for (int i = 0; i < 4; ++i) { // pressed, and pulled along beyond the cone
      const SurfacePoint<3> p = model.tools[0]->point(model.poses(state.q)[0], state.nodes[i].place);
      load.segment<3>(3 * i) = p.n + p.E * Param<3>(0.4 + 0.1 * i, -0.3) - own.segment<3>(3 * i);
    }
    if (mu > 0) turn_slips(model, force(u), state);
  }
  void touch(const Surface<3>& surface, int i, const Vector<3>& near, const Param<3>& slip) {
    ContactNode<3>& node = state.nodes[i];
    node.tool = 0;
    place_at(node, surface.foot(near, Param<3>::Zero()).place);
    const SurfaceFrame<3> frame = surface.frame(node.place);
    if (i == 2) node.state = NodeState::STICKING;
    if (i != 2) {
      const Vector<3> way =
          i == 3 ? Vector<3>(0.05 * Vector<3>::UnitY().cross(frame.n)) : Vector<3>(frame.E * slip);
      node.slip_origin = surface.foot(node.place.y - way, node.place.hint).place;
      make_slide(node, Vector<3>(model.laws[0].frictionless() ? Vector<3>::Zero() : way.normalized()));
    }
    u.segment<3>(3 * i) = model.tools[0]->position(model.poses(state.q)[0], node.place);
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
  /// Slips of nodes 0 and 1; free nodes; x, z, spiny, which keep the tool in the plane of symmetry.
  std::vector<int> unknowns() const { return {0, 1, 3, 4, 12, 13, 14, 15, 16, 17, 18, 20, 22}; }
  /// Residual after a change z of slips, free nodes and coordinates; rows of slips in the tool's frame, seen in the tangents
  /// before the change.
  Eigen::VectorXd residual(const Eigen::VectorXd& z, double guided) const {
    const Tool<3>& tool = *model.tools[0];
    const Surface<3>& surface = tool.surface();
    const Eigen::VectorXd q = state.q + z.tail(6);
    const auto pose = model.poses(q)[0];
    Eigen::VectorXd x = u, r = Eigen::VectorXd::Zero(z.size());
    std::vector<ContactNode<3>> nodes = state.nodes;
    for (int d = 12; d < DOFS; ++d) x[d] += z[d];
    for (int i = 0; i < 4; ++i) {
      Param<3> slip = z.segment<2>(3 * i);
      if (i == 3) slip = guided * guide(nodes[3]);
      nodes[i].place = surface.moved(nodes[i].place, slip);
      x.segment<3>(3 * i) = tool.position(pose, nodes[i].place);
      if (i == 3) x[10] = u[10];
    }
    const Eigen::VectorXd R = force(x);
    r.segment<6>(12) = R.segment<6>(12);
    for (int i = 0; i < 4; ++i) {
      const SurfacePoint<3> p = tool.point(pose, nodes[i].place);
      const SurfaceForce<3> part = nodal_force(model, i, p, Vector<3>(R.segment<3>(3 * i))).part;
      const Vector<3> F = nodal_force(model, i, p, Vector<3>(R.segment<3>(3 * i))).F;
      r.tail(6) += p.x_q.transpose() * F;
      if (i == 2) continue;
      const Param<3> slip = slip_of(model, nodes[i]), tau = part.T - state.slip_stiffness * slip;
      const double g = model.laws[0].friction().limit(part.N, 1);
      Param<3> m = i == 3 ? contact_point(model, model.poses(q), nodes[3]).m : Param<3>(-tau.normalized());
      const Param<3> row = part.T + g * m;
      r.segment<2>(3 * i) =
          surface.frame(state.nodes[i].place).E.transpose() * (surface.frame(nodes[i].place).E * row);
    }
    return r;
  }
  /// Free direction of the guided node in its tangents, the way it slides.
  Param<3> guide(const ContactNode<3>& node) const {
    const SurfacePoint<3> p = model.tools[0]->point(model.poses(state.q)[0], node.place);
    const Param<3> s = p.E.transpose() * Vector<3>::UnitY().cross(p.n);
    return s.normalized();
  }
};

std::vector<std::shared_ptr<const Surface<3>>> surfaces() {
  AxisFrame axis;
  axis.base << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  axis.point = Vector<3>(0, -4, 0);
  AxisFrame ring = axis;
  ring.point.setZero();
  return {std::make_shared<PlaneSurface>(Vector<3>(0, 0, 1), Vector<3>(0, 0, 1), 1), cylinder(1.5, 8, axis),
          sphere(1.3), torus(1.2, 0.4, ring)};
}

} // namespace

TEST(CondensedInSpace, TangentAgainstFiniteDifferences) {
  for (const auto& surface : surfaces()) {
    SpaceSample s(surface, 0.3);
    const Eigen::MatrixXd K = s.tangent();
    const std::vector<int> list = s.unknowns();
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(24, 24);
    for (const int j : list)
      expected.col(j) = finite_difference(
          [&](double t) { return s.residual(t * Eigen::VectorXd::Unit(24, j), 0); }, 0, 1e-3);
    const std::vector<int> slips = {0, 1, 3, 4}, nodes = {12, 13, 14, 15, 16, 17}, q = {18, 20, 22};
    for (const auto& rows : {slips, nodes, q})
      for (const auto& columns : {slips, nodes, q})
        EXPECT_LE((K(rows, columns) - expected(rows, columns)).norm(), 1e-7 * expected(rows, columns).norm())
            << "rows " << rows[0] << ", columns " << columns[0];
  }
}

// Slip and row of the node on the symmetry plane along its only free direction.
TEST(CondensedInSpace, GuidedNode) {
  for (const auto& surface : surfaces()) {
    SpaceSample s(surface, 0.3);
    const Eigen::MatrixXd K = s.tangent();
    const Param<3> along = s.guide(s.state.nodes[3]);
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(24),
                          column = finite_difference([&](double t) { return s.residual(zero, t); }, 0, 1e-3);
    const Eigen::VectorXd ours = K.middleCols<2>(9) * along;
    const Param<3> across(-along[1], along[0]);
    for (const int row : s.unknowns()) EXPECT_NEAR(ours[row], column[row], 1e-7 * column.norm());
    EXPECT_NEAR(along.dot(ours.segment<2>(9)), along.dot(column.segment<2>(9)), 1e-7 * column.norm());
    EXPECT_NEAR(across.dot(ours.segment<2>(9)), 0, 1e-12 * ours.norm());
  }
}

TEST(CondensedInSpace, SymmetricWithoutFriction) {
  for (const auto& surface : surfaces()) {
    SpaceSample s(surface, 0);
    const Eigen::MatrixXd K = s.tangent();
    EXPECT_LE((K - K.transpose()).norm(), 1e-14 * K.norm());
  }
}

// Two given components leave no slip; one leaves slip with friction in the plane of symmetry.
TEST(CondensedInSpace, SupportsAndFriction) {
  SpaceSample s(surfaces()[1], 0.3);
  EXPECT_TRUE(s.model.can_slip(3));
  EXPECT_FALSE(s.model.law(3, 0).frictionless());
  s.model.constrained[3] = {true, true, false};
  EXPECT_FALSE(s.model.can_slip(3));
  EXPECT_TRUE(s.model.law(3, 0).frictionless());
  s.model.constrained[3] = {false, true, false};
  s.model.weightless.assign(6, 0);
  s.model.weightless[0] = 1;
  EXPECT_TRUE(s.model.law(0, s.state.nodes[0]).frictionless());
  s.state.nodes[0].bears = true;
  EXPECT_FALSE(s.model.law(0, s.state.nodes[0]).frictionless());
}

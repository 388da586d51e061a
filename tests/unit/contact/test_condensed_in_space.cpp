// The condensed tangent of space against finite differences of the cone form: slips that turn, a node on a symmetry plane,
// every kind of surface.
#include "unit/contact/bound_nodes.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Nodes 0 and 1 slide, 2 sticks, 3 slides on a symmetry plane (u_y given), 4 and 5 are free.
struct SpaceSample : BoundNodes<6> {
  SpaceSample(std::shared_ptr<const Surface<3>> shape, double mu) : BoundNodes(std::move(shape), mu, 7) {
    model.constrained.assign(NODES, {false, false, false});
    model.constrained[3][1] = true;
    body.fixed[10] = 1;
    state.q << 0.1, 0, -0.2, 0, 0.3, 0; // in its symmetry plane
    const Vector<3> above[] = {{0.2, 0.3, 2}, {-0.3, 0.4, 2.1}, {0.4, -0.2, 1.9}, {0.15, 0, 2}};
    for (int i = 0; i < 4; ++i) {
      touch(i, above[i]);
      if (i < 2) slide(i, tangent_vector(i, Param<3>(0.05 * any(), 0.05 * any())));
    }
    slide(3, 0.05 * Vector<3>::UnitY().cross(surface().frame(state.nodes[3].place).n));
    settle();
    press(4, [](int i) { return Param<3>(0.4 + 0.1 * i, -0.3); }); // beyond the cone
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
      const Param<3> slip = slip_of(model, nodes[i], 1), tau = part.T - state.slip_stiffness * slip;
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

} // namespace

TEST(CondensedInSpace, TangentAgainstFiniteDifferences) {
  for (const auto& surface : four_surfaces()) {
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
  for (const auto& surface : four_surfaces()) {
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
  for (const auto& surface : four_surfaces()) {
    SpaceSample s(surface, 0);
    const Eigen::MatrixXd K = s.tangent();
    EXPECT_LE((K - K.transpose()).norm(), 1e-14 * K.norm());
  }
}

// Two given components leave no slip; one leaves slip with friction in the plane of symmetry.
TEST(CondensedInSpace, SupportsAndFriction) {
  SpaceSample s(four_surfaces()[1], 0.3);
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

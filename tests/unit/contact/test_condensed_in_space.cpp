// The condensed tangent of space against finite differences of the cone form: slips that turn, a node on a symmetry plane,
// every kind of surface in every kind of coordinates.
#include "support/script_tool.hpp"
#include "unit/contact/bound_nodes.hpp"
#include "unit/geometry/surface_samples.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Nodes 0 and 1 slide, 2 sticks, 3 slides on a symmetry plane (u_y given) or is free, 4 and 5 are free.
struct SpaceSample : BoundNodes<6> {
  int touching = 4;
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
  /// Without a symmetry plane, anywhere in any coordinates.
  SpaceSample(const std::shared_ptr<const Surface<3>>& shape, const CoordinatesCall& call, double mu)
      : BoundNodes(shape, mu, 7, coordinates_of(call)), touching(3) {
    model.constrained.assign(NODES, {false, false, false});
    state.q = Eigen::Map<const Eigen::VectorXd>(call.q.data(), Q);
    const auto places = smooth_places(*shape, 40, 0.15);
    for (int i = 0; i < touching; ++i) {
      touch(i, places.at(2 + i * (places.size() - 4) / 2).y);
      if (i < 2) slide(i, tangent_vector(i, Param<3>(0.05 * any(), 0.05 * any())));
    }
    settle();
    press(touching, [](int i) { return Param<3>(0.4 + 0.1 * i, -0.3); }); // beyond the cone
  }
  std::vector<int> slips() const { return {0, 1, 3, 4}; }
  std::vector<int> free() const { return range(3 * touching, DOFS, 1); }
  /// With a symmetry plane those that keep the tool in it: x, z, spiny.
  std::vector<int> coordinates() const { return range(DOFS, DOFS + Q, touching == 4 ? 2 : 1); }
  std::vector<int> unknowns() const {
    std::vector<int> all = slips();
    for (const auto& more : {free(), coordinates()}) all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  static std::vector<int> range(int from, int end, int step) {
    std::vector<int> list;
    for (int i = from; i < end; i += step) list.push_back(i);
    return list;
  }
  /// Residual after a change z of slips, free nodes and coordinates; rows of slips in the tool's frame, seen in the tangents
  /// before the change.
  Eigen::VectorXd residual(const Eigen::VectorXd& z, double guided) const {
    const Tool<3>& tool = *model.tools[0];
    const Surface<3>& surface = tool.surface();
    const Eigen::VectorXd q = state.q + z.tail(Q);
    const auto pose = model.poses(q)[0];
    Eigen::VectorXd x = u, r = Eigen::VectorXd::Zero(z.size());
    std::vector<ContactNode<3>> nodes = state.nodes;
    for (const int d : free()) x[d] += z[d];
    for (int i = 0; i < touching; ++i) {
      Param<3> slip = z.segment<2>(3 * i);
      if (i == 3) slip = guided * guide(nodes[3]);
      nodes[i].place = surface.moved(nodes[i].place, slip);
      x.segment<3>(3 * i) = tool.position(pose, nodes[i].place);
      if (i == 3) x[10] = u[10];
    }
    const Eigen::VectorXd R = force(x);
    for (const int d : free()) r[d] = R[d];
    for (int i = 0; i < touching; ++i) {
      const SurfacePoint<3> p = tool.point(pose, nodes[i].place);
      const SurfaceForce<3> part = nodal_force(model, i, p, Vector<3>(R.segment<3>(3 * i))).part;
      const Vector<3> F = nodal_force(model, i, p, Vector<3>(R.segment<3>(3 * i))).F;
      r.tail(Q) += p.x_q.transpose() * F;
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

void check_blocks(SpaceSample s) {
  const Eigen::MatrixXd K = s.tangent();
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(K.rows(), K.cols());
  for (const int j : s.unknowns())
    expected.col(j) = finite_difference(
        [&](double t) { return s.residual(t * Eigen::VectorXd::Unit(K.cols(), j), 0); }, 0, 1e-3);
  for (const auto& rows : {s.slips(), s.free(), s.coordinates()})
    for (const auto& columns : {s.slips(), s.free(), s.coordinates()}) {
      EXPECT_LE((K(rows, columns) - expected(rows, columns)).norm(), 1e-7 * expected(rows, columns).norm())
          << "rows " << rows[0] << ", columns " << columns[0];
    }
}

} // namespace

TEST(CondensedInSpace, TangentAgainstFiniteDifferences) {
  for (const auto& surface : four_surfaces()) check_blocks(SpaceSample(surface, 0.3));
}

TEST(CondensedInSpace, EverySurfaceInEveryKindOfCoordinates) {
  const auto every = surfaces(skew_axis());
  for (const std::string name :
       {"plane", "sphere", "cylinder", "frustum", "torus", "turned cam", "swept cam"})
    for (const auto& call : coordinates_calls()) {
      SCOPED_TRACE(name + " in " + call.name);
      const auto found =
          std::find_if(every.begin(), every.end(), [&](const NamedSurface& s) { return s.name == name; });
      ASSERT_NE(found, every.end());
      check_blocks(SpaceSample(found->surface, call, 0.3));
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

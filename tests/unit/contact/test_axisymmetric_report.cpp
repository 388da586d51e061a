// The report of an axisymmetric contact surface: rings' areas, pressures up to the axis, where vertices of
// quadratic elements have no area.
#include "contact/corner_shares.hpp"
#include "contact/surface_report.hpp"
#include "geometry/segment.hpp"
#include "kinematics/cartesian.hpp"
#include "support/profile_tool.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double RADII[] = {0, 1, 3, 6, 0.5, 2, 4.5}; // three edges: ends, then middles
const auto CONSTANT = [](double) { return 100.; };

/// A cone under a line that lies on it: nodes 0..3 from the axis outwards, middle nodes 4..6. u doubles all lengths,
/// so that the present radii are 2 x RADII; the line falls by `fall` per unit of radius.
struct Cone {
  ContactModel<2> model;
  BodyView<2> body;
  ContactState<2> state;
  std::vector<Facet<2>> edges;
  Eigen::VectorXd u;
  Vector<2> along, normal; // outwards; of the tool, into the body
  int nodes;

  explicit Cone(bool quadratic, double fall = 0) : nodes(quadratic ? 7 : 4) {
    along = Vector<2>(1, -fall).normalized();
    normal = Vector<2>(along[1], -along[0]);
    body.measure = std::make_shared<EdgeMeasure>(true);
    body.X.resize(2 * nodes);
    for (int a = 0; a < nodes; ++a) {
      body.X.segment<2>(2 * a) = RADII[a] / along[0] * along;
      model.candidates.push_back(a);
    }
    for (int e = 0; e < 3; ++e) edges.push_back({{e + 1, e}, {quadratic ? 4 + e : -1}, -1, 0});
    u = body.X;
    body.fixed.assign(2 * nodes, 0);
    const auto line = std::make_shared<Segment>(50 * along, -50 * along);
    model.tools = {profile_tool("die", line, std::make_shared<Cartesian>())};
    model.laws.emplace_back(make_coulomb(0.3));
    model.first = {0, 3};
    state.q = Vector<3>::Zero();
    state.nodes.resize(nodes);
    for (int a = 0; a < nodes; ++a) touch(a);
  }
  void touch(int a) {
    state.nodes[a].state = a % 2 ? NodeState::STICKING : NodeState::SLIDING;
    state.nodes[a].tool = 0;
    place_at(state.nodes[a], place_of(*model.tools[0], 50 - radius(a) / along[0]));
  }
  double inner = 0; // of node 0, undeformed
  double radius(int a) const { return a == 0 ? 2 * inner : a == 4 ? inner + 1 : 2 * RADII[a]; }
  /// Consistent forces of a pressure p(r) and of 0.2 of it along the tool's tangent: integrals of N p 2 pi r dl by
  /// Boole's rule, exact to degree 5.
  template <class Pressure> Eigen::VectorXd loads(const Pressure& p) const {
    Eigen::VectorXd R = Eigen::VectorXd::Zero(2 * nodes);
    const double weight[] = {7. / 90, 32. / 90, 12. / 90, 32. / 90, 7. / 90};
    for (const Facet<2>& edge : edges)
      for (int k = 0; k < 5; ++k) {
        const double s = k / 4., t = 1 - s, a = radius(edge.vertex[0]), b = radius(edge.vertex[1]);
        const double r = t * a + s * b, area = weight[k] * 2 * M_PI * r * std::abs(b - a) / along[0];
        const bool linear = edge.middle[0] < 0;
        const Vector<2> load = area * p(r) * (normal - 0.2 * along);
        R.segment<2>(2 * edge.vertex[0]) += (linear ? t : t * (t - s)) * load;
        R.segment<2>(2 * edge.vertex[1]) += (linear ? s : s * (s - t)) * load;
        if (!linear) R.segment<2>(2 * edge.middle[0]) += 4 * s * t * load;
      }
    return R;
  }
  template <class Pressure> SurfaceReport<2> report(const Pressure& p) const {
    return surface_report(model, body, state, edges, u, loads(p));
  }
};

/// Everywhere 100, and 20 along the tangent.
void expect_uniform(const SurfaceReport<2>& report, int first = 0) {
  const double least = NO_AREA * report.area.maxCoeff();
  for (Eigen::Index a = first; a < report.pressure.size(); ++a) {
    EXPECT_NEAR(report.pressure[a], 100, 1e-9) << a;
    EXPECT_NEAR(report.traction_tangential(0, a), 20, 1e-9) << a;
    const bool none = report.area[a] <= least;
    EXPECT_NEAR(report.nodal_pressure[a], none ? 0 : 100, 1e-9) << a;
    EXPECT_NEAR(report.nodal_traction(0, a), none ? 0 : 20, 1e-9) << a;
  }
}

} // namespace

// The rings of all nodes are the whole cone; a vertex of quadratic elements on the axis has none of it.
TEST(AxisymmetricReport, TributaryAreasArePartsOfTheCone) {
  for (const double fall : {0., 0.75})
    for (const bool quadratic : {false, true}) {
      const Cone cone(quadratic, fall);
      const Eigen::VectorXd area = tributary_areas(cone.model, cone.body, cone.edges, cone.u);
      const double whole = M_PI * 12 * 12 / cone.along[0];
      EXPECT_NEAR(area.sum(), whole, 1e-12 * whole);
      // of a ring from 0 to 2: linear 2 pi l (2 r_a + r_b)/6, quadratic 2 pi l r_a/6
      EXPECT_NEAR(area[0], quadratic ? 0 : 2 * M_PI * 2 / 6 * 2 / cone.along[0], 1e-14 * whole);
      if (!quadratic) continue;
      EXPECT_NEAR(area[4], 2 * M_PI * 2 * 2 / 3 / cone.along[0], 1e-14 * whole);
    }
}

TEST(AxisymmetricReport, UniformPressureEverywhere) {
  for (const double fall : {0., 0.75})
    for (const bool quadratic : {false, true}) {
      SCOPED_TRACE(quadratic ? "quadratic" : "linear");
      const Cone cone(quadratic, fall);
      const auto report = cone.report(CONSTANT);
      expect_uniform(report);
      EXPECT_NEAR(report.normal_force.sum(), 100 * M_PI * 144 / cone.along[0], 1e-8);
    }
}

// A vertex on the axis of quadratic elements has no force of its own: its state does not matter.
TEST(AxisymmetricReport, VertexOnTheAxisInAnyState) {
  for (const NodeState state :
       {NodeState::FREE, NodeState::TOUCHED, NodeState::STICKING, NodeState::LEAVING, NodeState::RECEDING}) {
    Cone cone(true);
    cone.state.nodes[0].state = state;
    expect_uniform(cone.report(CONSTANT));
  }
}

// A mesh that ends beside the axis: the vertex there has hardly an area, and a force that is the difference of two effects.
// Its pressure is that by shares, in contact or not; a vertex half an edge away has its own.
TEST(AxisymmetricReport, VertexBesideTheAxis) {
  const auto pressure = [](double r) { return 100 - 5 * r; };
  for (const double radius : {1e-7, 1e-4, 0.1, 0.5})
    for (const NodeState state : {NodeState::SLIDING, NodeState::FREE}) {
      if (radius == 0.5 && state == NodeState::FREE) continue;
      Cone cone(true);
      cone.body.X[0] = radius;
      cone.body.X[2 * 4] = (radius + 1) / 2;
      cone.u = cone.body.X;
      cone.inner = radius;
      cone.state.nodes[0].state = state;
      cone.state.nodes[0].tool = state == NodeState::FREE ? -1 : 0;
      const auto report = cone.report(pressure);
      const double own = report.normal_force[0] / report.area[0];
      EXPECT_NEAR(report.nodal_pressure[0], own, 1e-12 * std::abs(own)) << radius;
      const bool free = state == NodeState::FREE; // the shares lose the vertex's own force then
      if (radius < 0.5) {                         // on the axis that of half an edge inside, METHOD.md 3.20
        EXPECT_NEAR(report.pressure[0], pressure(2 * radius + 1), free ? 10 : 1) << radius;
      }
      if (radius == 1e-4 && !free) {
        EXPECT_GT(std::abs(own - 100), 1e2) << "what it would be";
      }
    }
}

// A node on the axis is held across it: without friction there.
TEST(AxisymmetricReport, ConstrainedNodeOnTheAxis) {
  for (const bool quadratic : {false, true}) {
    Cone cone(quadratic);
    cone.model.constrained.assign(cone.nodes, {false, false});
    cone.model.constrained[0][0] = true;
    const auto report = cone.report(CONSTANT);
    expect_uniform(report, 1);
    EXPECT_NEAR(report.pressure[0], 100, 1e-9);
    EXPECT_NEAR(report.nodal_pressure[0], quadratic ? 0 : 100, 1e-9) << "it has no area";
    EXPECT_EQ(report.tangential_force(0, 0), 0);
  }
}

// Linear along quadratic edges: the shares are those of linear edges under the same pressure, with the radius of the rings,
// to the last node, the axis included; and friction of mu p has mu times these shares.
TEST(AxisymmetricReport, SharesAreConsistentWithLinearEdges) {
  const Cone cone(true, 0.75), linear(false, 0.75);
  const auto pressure = [](double r) { return 100 - 8 * r; };
  const auto report = cone.report(pressure), expected = linear.report(pressure);
  const CornerShares<2> shares(cone.model, cone.body, cone.state, cone.edges, cone.u, report.area);
  const Eigen::VectorXd N = shares.shared(report.normal_force),
                        T = shares.shared(report.tangential_force.row(0).transpose());
  const double scale = report.normal_force.cwiseAbs().maxCoeff();
  ASSERT_EQ(N.size(), 4);
  for (int c = 0; c < 4; ++c) {
    const int corner = shares.corners()[c];
    EXPECT_NEAR(N[c], expected.normal_force[corner], 1e-13 * scale) << corner;
    EXPECT_NEAR(T[c], 0.2 * N[c], 1e-13 * scale) << corner;
    EXPECT_NEAR(shares.areas()[c], expected.area[corner], 1e-13 * report.area.maxCoeff()) << corner;
    EXPECT_NEAR(report.pressure[corner], expected.pressure[corner], 1e-10) << corner;
  }
}

// Contact from the axis to r = 6, linear to zero there: what is reported adds up to the forces.
TEST(AxisymmetricReport, SumAtAFreeEnd) {
  Cone cone(true);
  for (const int free : {2, 3, 6}) cone.state.nodes[free] = {};
  const auto report = cone.report([](double r) { return r < 6 ? 100 - 100 * r / 6 : 0; });
  double sum = 0;
  for (const Facet<2>& edge : cone.edges) {
    const double a = cone.radius(edge.vertex[0]), b = cone.radius(edge.vertex[1]),
                 pa = report.pressure[edge.vertex[0]], pb = report.pressure[edge.vertex[1]];
    sum += 2 * M_PI * std::abs(b - a) * ((2 * a + b) * pa + (a + 2 * b) * pb) / 6;
  }
  EXPECT_NEAR(sum, report.normal_force.sum(), 1e-12 * sum);
  for (const int free : {2, 3, 6}) EXPECT_EQ(report.pressure[free], 0);
  EXPECT_NEAR(report.pressure[1], 100 * 4 / 6., 1);
}

TEST(AxisymmetricReport, LinearFacetsHaveNoShares) {
  const Cone linear(false), quadratic(true);
  const auto empty = [](const Cone& cone) {
    const Eigen::VectorXd area = tributary_areas(cone.model, cone.body, cone.edges, cone.u);
    return CornerShares<2>(cone.model, cone.body, cone.state, cone.edges, cone.u, area).empty();
  };
  EXPECT_TRUE(empty(linear));
  EXPECT_FALSE(empty(quadratic));
  Cone free(true);
  for (auto& node : free.state.nodes) node = {};
  EXPECT_TRUE(empty(free)) << "no facet in contact";
  const auto report = free.report([](double) { return 0.; });
  EXPECT_EQ(report.pressure.norm(), 0);
}

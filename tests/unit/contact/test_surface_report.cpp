// The report of the contact surface: tributary lengths, uniform pressure recovered, forces shared to corners, gaps.
#include "contact/corner_shares.hpp"
#include "contact/surface_report.hpp"
#include "geometry/segment.hpp"
#include "geometry/simple_surfaces.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/formula_coordinates.hpp"
#include "support/profile_tool.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// A straight surface of three edges of lengths 1, 2, 3 (nodes 0..3, middle nodes 4..6), sloping, under a
/// line that lies on it; u doubles all lengths.
struct Sample {
  ContactModel<2> model;
  BodyView<2> body;
  ContactState<2> state;
  std::vector<Facet<2>> edges;
  Eigen::VectorXd u;
  Vector<2> along = Vector<2>(0.8, 0.6), normal = Vector<2>(0.6, -0.8); // tool's normal, into the body

  explicit Sample(bool quadratic) {
    body.measure = std::make_shared<EdgeMeasure>();
    const double places[] = {0, 1, 3, 6, 0.5, 2, 4.5}; // along the surface
    const int nodes = quadratic ? 7 : 4;
    body.X.resize(2 * nodes);
    for (int a = 0; a < nodes; ++a) {
      body.X.segment<2>(2 * a) = places[a] * along;
      model.candidates.push_back(a);
    }
    for (int e = 0; e < 3; ++e) edges.push_back({{e, e + 1}, {quadratic ? 4 + e : -1}, -1, 0});
    u = body.X;
    body.fixed.assign(2 * nodes, 0);
    model.tools = {profile_tool("line", std::make_shared<Segment>(20 * along, -20 * along),
                                std::make_shared<Cartesian>())};
    model.laws.emplace_back(make_coulomb(0.3));
    model.first = {0, 3};
    state.q = Vector<3>::Zero();
    state.nodes.resize(nodes);
    for (int a = 0; a < nodes; ++a) {
      state.nodes[a].state = a % 2 ? NodeState::STICKING : NodeState::SLIDING;
      state.nodes[a].tool = 0;
      place_at(state.nodes[a], place_of(*model.tools[0], 20 - 2 * places[a]));
    }
  }
  /// Consistent nodal forces of the pressure p0 + p1 (place) and 0.2 of it as traction along the tool's
  /// tangent.
  Eigen::VectorXd loads(double p0, double p1) const {
    Eigen::VectorXd R = Eigen::VectorXd::Zero(body.X.size());
    const Vector<2> pull = normal - 0.2 * along;
    for (const Facet<2>& e : edges) {
      const double length =
          2 * (body.X.segment<2>(2 * e.vertex[1]) - body.X.segment<2>(2 * e.vertex[0])).norm();
      const double a = p0 + p1 * body.X.segment<2>(2 * e.vertex[0]).norm(),
                   b = p0 + p1 * body.X.segment<2>(2 * e.vertex[1]).norm();
      const bool linear = e.middle[0] < 0;
      R.segment<2>(2 * e.vertex[0]) += length * (linear ? a / 3 + b / 6 : a / 6) * pull;
      R.segment<2>(2 * e.vertex[1]) += length * (linear ? b / 3 + a / 6 : b / 6) * pull;
      if (!linear) R.segment<2>(2 * e.middle[0]) += length * (a + b) / 3 * pull;
    }
    return R;
  }
  SurfaceReport<2> report(const Eigen::VectorXd& R) const {
    return surface_report(model, body, state, edges, u, R);
  }
};

} // namespace

TEST(SurfaceReport, TributaryLengthsOfThePresentShape) {
  const Eigen::VectorXd linear = Sample(false).report(Eigen::VectorXd::Zero(8)).area;
  expect_close(linear, Eigen::Vector4d(1, 3, 5, 3), 1, 1e-14, "linear edges");
  Eigen::VectorXd expected(7);
  expected << 1. / 3, 1, 5. / 3, 1, 4. / 3, 8. / 3, 4;
  expect_close(Sample(true).report(Eigen::VectorXd::Zero(14)).area, expected, 1, 1e-14, "quadratic edges");
}

TEST(SurfaceReport, UniformPressureRecovered) {
  for (const bool quadratic : {false, true}) {
    const Sample surface(quadratic);
    const auto report = surface.report(surface.loads(5, 0));
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(report.nodal_pressure.size());
    expect_close(report.nodal_pressure, 5 * ones, 5, 1e-14, "nodal pressure");
    expect_close(report.nodal_traction, ones, 1, 1e-14, "nodal traction");
    expect_close(report.pressure, 5 * ones, 5, 1e-13, "pressure");
    expect_close(report.traction_tangential, ones, 1, 1e-13, "traction");
    EXPECT_NEAR(report.normal_force.sum(), 5 * 12, 1e-12);
    EXPECT_NEAR(report.tangential_force.sum(), 12, 1e-12);
  }
}

// On quadratic edges a pressure that is linear along the surface has the shares of linear edges, h/3 p_a + h/6 p_b, to
// rounding, and friction that is mu p everywhere is mu times them: the cone holds with equality at every corner.
TEST(SurfaceReport, SharesAreConsistentWithLinearEdges) {
  const Sample quadratic(true), linear(false);
  const auto report = quadratic.report(quadratic.loads(3, 0.5));
  const CornerShares<2> shares(quadratic.model, quadratic.body, quadratic.state, quadratic.edges, quadratic.u,
                               report.area);
  ASSERT_EQ(shares.corners().size(), 4u);
  const Eigen::VectorXd N = shares.shared(report.normal_force),
                        T = shares.shared(report.tangential_force.row(0).transpose()),
                        expected = linear.report(linear.loads(3, 0.5)).normal_force;
  for (int c = 0; c < 4; ++c) {
    const int corner = shares.corners()[c];
    EXPECT_NEAR(N[c], expected[corner], 1e-13 * 6) << corner;
    EXPECT_NEAR(T[c], 0.2 * N[c], 1e-13 * 6) << corner;
    EXPECT_NEAR(shares.areas()[c], linear.report(linear.loads(3, 0.5)).area[corner], 1e-14 * 6);
    EXPECT_DOUBLE_EQ(report.pressure[corner], N[c] / shares.areas()[c]);
  }
  for (int e = 0; e < 3; ++e)
    EXPECT_DOUBLE_EQ(report.pressure[4 + e], 0.5 * (report.pressure[e] + report.pressure[e + 1]));
}

// The integral of the reported pressure is the sum of the nodal forces, wherever the contact ends.
TEST(SurfaceReport, SharedPressureAddsUpToTheForces) {
  for (const std::vector<int>& free : {std::vector<int>{}, {3}, {3, 6}, {3, 6, 2}, {0, 1, 2, 3, 4, 6}}) {
    Sample surface(true);
    for (const int a : free) surface.state.nodes[a] = {};
    const auto report = surface.report(surface.loads(3, 0.5));
    double sum = 0;
    for (int e = 0; e < 3; ++e) sum += (e + 1) * (report.pressure[e] + report.pressure[e + 1]);
    EXPECT_NEAR(sum, report.normal_force.sum(), 1e-13 * sum) << free.size();
    EXPECT_GE(report.pressure.minCoeff(), 0) << free.size();
    EXPECT_GT(sum, 0);
  }
}

TEST(SurfaceReport, ShareThatSticks) {
  Sample surface(true);
  for (auto& node : surface.state.nodes)
    node.state = NodeState::SLIDING; // what counts is the friction, 0.2 of 0.3
  const Eigen::VectorXd loads = surface.loads(5, 0);
  EXPECT_EQ(surface.report(loads).stick_share, 1);
  surface.model.laws = {TangentialLaw<2>(make_coulomb(0.201))};
  EXPECT_EQ(surface.report(loads).stick_share, 0);
  Sample nodes(false);
  EXPECT_NEAR(nodes.report(nodes.loads(5, 0)).stick_share, 0.5, 1e-14) << "by states: 3 and 3 of 12";
}

TEST(SurfaceReport, FreeNodesHaveGapsAndNoForce) {
  Sample surface(false);
  surface.state.nodes[0] = {};
  surface.u.segment<2>(0) += 0.25 * surface.normal;
  const auto report = surface.report(surface.loads(5, 0));
  EXPECT_NEAR(report.gap[0], 0.25, 1e-14);
  EXPECT_EQ(report.normal_force[0], 0);
  EXPECT_EQ(report.pressure[0], 0);
  EXPECT_EQ(report.gap[1], 0);
  EXPECT_NEAR(report.pressure[2], 5, 1e-13);
  EXPECT_EQ((report.pressure - report.nodal_pressure).norm(), 0) << "linear edges";
}

// Quadratic triangles about the pole of a large ball, where tangents of neighboring nodes point into all directions: the
// uniform traction whose nodal forces are given, at vertices none, at mid nodes a third of every area, comes back in x, y, z.
TEST(SurfaceReport, ShearOfSpaceDoesNotHangOnTangents) {
  constexpr double radius = 1e6;
  const Vector<3> pull(0.2, 0.1, -1);
  Mesh<3> mesh;
  mesh.X = {0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0};
  for (const auto& [x, y] : {std::pair{0.5, 0.},
                             {0., 0.5},
                             {-0.5, 0.},
                             {0., -0.5},
                             {0.5, 0.5},
                             {-0.5, 0.5},
                             {-0.5, -0.5},
                             {0.5, -0.5}})
    mesh.X.insert(mesh.X.end(), {x, y, 0});
  BodyView<3> body;
  body.X = Eigen::Map<const Eigen::VectorXd>(mesh.X.data(), 39);
  body.fixed.assign(39, 0);
  body.measure = std::make_shared<FaceMeasure>();
  Eigen::VectorXd R = Eigen::VectorXd::Zero(39);
  std::vector<Facet<3>> facets;
  for (int k = 0; k < 4; ++k) {
    facets.push_back({{0, 1 + k, 1 + (k + 1) % 4}, {9 + k, 5 + (k + 1) % 4, 5 + k}, -1, 0});
    for (const int middle : facets.back().middle) R.segment<3>(3 * middle) += 0.5 / 3 * pull;
  }
  ContactModel<3> model;
  model.tools = {
      std::make_shared<Tool<3>>("ball", sphere(radius),
                                std::make_shared<FormulaCoordinates<3>>("ball", std::vector<std::string>{"z"},
                                                                        SpaceFormulas{"0", "0", "z"}))};
  model.laws.emplace_back(make_coulomb(0.3));
  model.first = {0, 1};
  ContactState<3> state;
  state.q = Eigen::VectorXd::Constant(1, radius);
  state.nodes.resize(13);
  const auto poses = model.poses(state.q);
  for (int a = 0; a < 13; ++a) {
    model.candidates.push_back(a);
    state.nodes[a].state = NodeState::STICKING;
    state.nodes[a].tool = 0;
    place_at(state.nodes[a],
             model.tools[0]->foot(poses[0], Vector<3>(body.X.segment<3>(3 * a)), {0, 0}).place);
  }
  const auto report =
      surface_report(model, body, state, facets, Eigen::VectorXd(Eigen::VectorXd::Zero(39)), R);
  ASSERT_EQ(report.traction_tangential.rows(), 3);
  for (int a = 0; a < 13; ++a) {
    EXPECT_NEAR(report.pressure[a], 1, 1e-5) << a;
    EXPECT_LE((report.traction_tangential.col(a) - Vector<3>(0.2, 0.1, 0)).norm(), 1e-5) << a;
  }
  EXPECT_EQ(report.stick_share, 1) << "0.22 of 0.3";
}

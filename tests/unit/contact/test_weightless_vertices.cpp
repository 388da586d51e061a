// Vertices of quadratic triangles: no weight of their own, released by shared forces, no friction; the report by shares.
#include "contact/corner_shares.hpp"
#include "contact/surface_report.hpp"
#include "contact/tied_edges.hpp"
#include "contact/tool_support.hpp"
#include "geometry/plane_surface.hpp"
#include "support/pressed_body.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Top of a block under a plane that lies on it, all nodes in contact.
struct PlaneOnBlock {
  Discretization<3> mesh;
  ContactSetup<3> setup;
  ContactState<3> state;
  Eigen::VectorXd u, R;

  /// @param symmetric the plane y = 0 is one of symmetry
  explicit PlaneOnBlock(int nodes_per_element, bool symmetric = false,
                        std::shared_ptr<const FrictionLaw> friction = make_coulomb(0.3))
      : mesh(tetrahedra(block_of_tetrahedra({0, 0.7, 1.5, 2}, {0, 1, 1.6}, {-1, 0}, nodes_per_element))),
        setup(mesh, mesh.facets, supports(symmetric), std::make_shared<FaceMeasure>()),
        u(Eigen::VectorXd::Zero(mesh.num_dofs())), R(u) {
    auto tool = std::make_shared<DrivenTool<3>>(
        "plane", std::make_shared<PlaneSurface>(Vector<3>(0, 0, 0), Vector<3>(0, 0, -1), 1));
    tool->set_coordinates(std::make_shared<FormulaCoordinates<3>>(
        "plane", std::vector<std::string>{"x", "y", "z"}, SpaceFormulas{"x", "y", "z"}));
    setup.add_tool(tool, friction);
    setup.close();
    state.q = Vector<3>::Zero();
    state.nodes.resize(setup.candidates().size());
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
      state.nodes[i].state = NodeState::STICKING;
      state.nodes[i].tool = 0;
      SurfacePlace<3> place;
      place.y = mesh.node(setup.candidates()[i]);
      place_at(state.nodes[i], place);
    }
  }
  std::vector<char> supports(bool symmetric) const {
    std::vector<char> fixed(static_cast<std::size_t>(mesh.num_dofs()), 0);
    for (int a = 0; a < mesh.num_nodes; ++a) fixed[3 * a + 1] = symmetric && mesh.node(a)[1] < 1e-9;
    return fixed;
  }
  /// Forces of the pressure p(x), linear on every triangle, and shares of the vertices by hand.
  Eigen::VectorXd load(const std::function<double(const Vector<3>&)>& p) {
    const std::vector<int> candidate = candidate_of_node(setup.candidates(), mesh.num_nodes);
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(state.nodes.size()));
    for (const Facet<3>& facet : mesh.facets) {
      Vector<3> at;
      for (int v = 0; v < 3; ++v) at[v] = p(mesh.node(facet.vertex[v]));
      const Eigen::VectorXd N = FaceMeasure().masses(places_of(setup.body(), facet, u)) * at;
      const std::vector<int> nodes = nodes_of(facet);
      for (std::size_t i = 0; i < nodes.size(); ++i) R[3 * nodes[i] + 2] -= N[static_cast<Eigen::Index>(i)];
      const Vector<3> a = mesh.node(facet.vertex[1]) - mesh.node(facet.vertex[0]),
                      b = mesh.node(facet.vertex[2]) - mesh.node(facet.vertex[0]);
      const double area = 0.5 * a.cross(b).norm();
      for (int v = 0; v < 3; ++v) expected[candidate[facet.vertex[v]]] += area / 12 * (at.sum() + at[v]);
    }
    return expected;
  }
};

} // namespace

TEST(WeightlessVertices, SharedForcesOfLinearPressure) {
  for (const bool uniform : {true, false}) {
    PlaneOnBlock s(10);
    const auto& model = s.setup.model();
    const Eigen::VectorXd expected =
        s.load([&](const Vector<3>& x) { return uniform ? 2. : 1 + 0.7 * x[0] + 0.2 * x[1]; });
    const auto deciding = deciding_forces(model, s.state, model.poses(s.state.q), s.R);
    const SurfaceReport<3> report = surface_report(model, s.setup.body(), s.state, s.mesh.facets, s.u, s.R);
    const CornerShares<3> shares(model, s.setup.body(), s.state, s.mesh.facets, s.u, report.area);
    const Eigen::VectorXd shared = shares.shared(report.normal_force);
    int corners = 0;
    for (int i = 0; i < static_cast<int>(s.state.nodes.size()); ++i) {
      if (!model.is_weightless(i)) continue;
      ++corners;
      EXPECT_NEAR(deciding[i].normal, expected[i], 1e-14);
      EXPECT_GT(deciding[i].normal, 0);
      if (!uniform) continue;
      EXPECT_NEAR(deciding[i].force.N, 0, 1e-14) << "its own";
      EXPECT_NEAR(report.pressure[i], 2, 1e-13);
    }
    EXPECT_EQ(corners, 12);
    ASSERT_EQ(shared.size(), 12);
    for (Eigen::Index c = 0; c < 12; ++c) EXPECT_NEAR(shared[c], expected[shares.corners()[c]], 1e-14);
    EXPECT_NEAR(shares.areas().sum(), 3.2, 1e-14);
  }
}

TEST(WeightlessVertices, StickUnderALawThatAlwaysSticks) {
  const PlaneOnBlock sliding(10), stuck(10, false, std::make_shared<StickingFriction>());
  int corners = 0;
  for (int i = 0; i < static_cast<int>(stuck.state.nodes.size()); ++i) {
    const bool corner = stuck.setup.model().is_weightless(i);
    corners += corner;
    EXPECT_EQ(sliding.setup.model().law(i, sliding.state.nodes[i]).frictionless(), corner);
    EXPECT_TRUE(stuck.setup.model().law(i, stuck.state.nodes[i]).friction().sticks_always());
  }
  EXPECT_EQ(corners, 12);
}

TEST(WeightlessVertices, LinearTrianglesHaveNone) {
  PlaneOnBlock s(4);
  EXPECT_TRUE(s.setup.model().weightless.empty());
  EXPECT_TRUE(s.setup.model().edge_ends.empty());
  s.load([](const Vector<3>&) { return 1.; });
  const auto deciding = deciding_forces(s.setup.model(), s.state, s.setup.model().poses(s.state.q), s.R);
  for (const auto& own : deciding) EXPECT_DOUBLE_EQ(own.normal, own.force.N);
}

// Mid nodes of triangles know their ends, and are neighbors of one another.
TEST(WeightlessVertices, EdgesAndNeighbors) {
  const PlaneOnBlock s(10);
  const auto& model = s.setup.model();
  for (int i = 0; i < static_cast<int>(s.state.nodes.size()); ++i) {
    EXPECT_NE(model.is_weightless(i), model.is_middle(i));
    if (!model.is_middle(i)) continue;
    const auto x = [&](int k) { return s.mesh.node(model.candidates[k]); };
    const auto [a, b] = model.edge_ends[i];
    EXPECT_LE((x(i) - 0.5 * (x(a) + x(b))).norm(), 1e-15);
    EXPECT_TRUE(model.neighbors[i].size() == 4 || model.neighbors[i].size() == 6);
  }
}

// Linear pressure: with every edge tied the shares that decide over friction are exact too.
TEST(TiesOnTriangles, SharedForcesOfLinearPressure) {
  PlaneOnBlock s(10);
  const auto& model = s.setup.model();
  tie_edges(model, s.state.nodes, s.state);
  const Eigen::VectorXd expected = s.load([](const Vector<3>& x) { return 1 + 0.7 * x[0] + 0.2 * x[1]; });
  const auto deciding = deciding_forces(model, s.state, model.poses(s.state.q), s.R);
  for (int i = 0; i < static_cast<int>(s.state.nodes.size()); ++i) {
    EXPECT_EQ(s.state.nodes[i].tied, model.is_middle(i)) << "all have touched before";
    EXPECT_EQ(s.state.nodes[i].has_ties, model.is_weightless(i));
    if (!model.is_weightless(i)) continue;
    EXPECT_NEAR(deciding[i].force.N, expected[i], 1e-14);
    EXPECT_FALSE(deciding[i].unpressed);
  }
}

// Only nodes that have touched before the step are tied; a vertex without ties has no friction, one with ties takes up what its mid
// nodes do.
TEST(TiesOnTriangles, MadeOfNodesHeldBefore) {
  PlaneOnBlock s(10);
  const auto& model = s.setup.model();
  int middle = 0;
  while (!model.is_middle(middle)) ++middle;
  const auto [a, b] = model.edge_ends[middle];
  for (const int touched : {middle, a}) {
    auto before = s.state.nodes;
    make_free(before[touched]);
    ContactState<3> state = s.state;
    state.nodes[a].has_ties = true; // in the step before
    tie_edges(model, before, state);
    EXPECT_FALSE(state.nodes[middle].tied);
    if (touched != a) continue;
    EXPECT_FALSE(state.nodes[a].has_ties);
    EXPECT_EQ(state.nodes[a].state, NodeState::SLIDING);
    EXPECT_TRUE(model.law(a, state.nodes[a]).frictionless());
    EXPECT_FALSE(model.law(b, state.nodes[b]).frictionless());
  }
  const Vector<3> zero = Vector<3>::Zero(), along = Vector<3>::UnitX();
  make_slide(s.state.nodes[a], zero);
  ContactState<3> state = s.state;
  tie_edges(model, s.state.nodes, state);
  EXPECT_EQ(state.nodes[a].state, NodeState::STICKING) << "its mid nodes stick";
  for (int i = 0; i < static_cast<int>(s.state.nodes.size()); ++i)
    if (model.is_middle(i)) make_slide(s.state.nodes[i], along);
  state = s.state;
  tie_edges(model, s.state.nodes, state);
  EXPECT_EQ(state.nodes[a].state, NodeState::SLIDING);
  EXPECT_EQ(state.nodes[a].slip_direction, along);
}

TEST(TiesOnTriangles, DroppedTieDoesNotReturn) {
  PlaneOnBlock s(10);
  const auto& model = s.setup.model();
  tie_edges(model, s.state.nodes, s.state);
  int corner = 0;
  while (!model.is_weightless(corner)) ++corner;
  const ContactNode<3> before = s.state.nodes[corner];
  make_free(s.state.nodes[corner]);
  follow_ends(model, s.state);
  const auto ties = [&] {
    int number = 0;
    for (int i = 0; i < static_cast<int>(s.state.nodes.size()); ++i) {
      const auto& ends = model.edge_ends[i];
      if (ends[0] == corner || ends[1] == corner) number += s.state.nodes[i].tied;
    }
    return number;
  };
  EXPECT_EQ(ties(), 0);
  s.state.nodes[corner] = before;
  follow_ends(model, s.state);
  EXPECT_EQ(ties(), 0) << "in the same step";
  EXPECT_FALSE(s.state.nodes[corner].has_ties);
  EXPECT_EQ(s.state.nodes[corner].state, NodeState::SLIDING) << "without ties it does not stick";
  EXPECT_TRUE(model.law(corner, s.state.nodes[corner]).frictionless());
}

// A vertex that its tied mid nodes do not press, held all the same by others: it slides, has no friction, and does not stick.
TEST(TiesOnTriangles, UnpressedVertexSlidesFreely) {
  PlaneOnBlock s(10);
  const auto& model = s.setup.model();
  tie_edges(model, s.state.nodes, s.state);
  int corner = 0;
  while (!model.is_weightless(corner)) ++corner;
  const int node = model.candidates[corner];
  s.R.segment<3>(3 * node) = Vector<3>(0.2, 0, 1); // pulled: the plane presses downward
  const auto poses = model.poses(s.state.q);
  const auto at = deciding_forces(model, s.state, poses, s.R)[corner];
  ASSERT_TRUE(at.unpressed);
  const TangentialLaw<3>& law = model.law(corner, s.state.nodes[corner]);
  ASSERT_FALSE(law.frictionless());
  const Param<3> m(1, 0), back(-1, 0);
  const ContactTolerance tolerance{1e-9, 1e-9};
  EXPECT_EQ(law.test(NodeState::STICKING, 1, at, Param<3>::Zero(), m, tolerance), Change::SLIDE);
  EXPECT_EQ(law.test(NodeState::SLIDING, 1, at, back, m, tolerance), Change::NONE) << "slipped back";
  EXPECT_NEAR(law.sliding_residual(at, m), 0.2, 1e-15);
  EXPECT_EQ(law.capacity(at), 0);
  EXPECT_EQ(law.cone(at).slope, 0);
  EXPECT_TRUE(law.turn(at, m, m, Curvature<3>::Identity(), 1).H.isZero(0));
}

// A vertex that alone holds a tool under force bears friction until a node with a weight sticks.
TEST(WeightlessVertices, BearUntilAnotherNodeSticks) {
  PlaneOnBlock s(10);
  const auto& model = s.setup.model();
  int middle = -1;
  for (int i = 0; i < static_cast<int>(s.state.nodes.size()); ++i)
    if (model.is_weightless(i))
      make_slide<3>(s.state.nodes[i], Vector<3>::Zero());
    else
      make_free(s.state.nodes[middle = i]);
  PrescribedValues prescribed{{0, 1, 1}, Eigen::VectorXd::Zero(3)};
  const int bearing = stick_unsupported(model, prescribed, s.state);
  ASSERT_GE(bearing, 0);
  relieve_vertices(model, s.state);
  EXPECT_TRUE(s.state.nodes[bearing].bears) << "nothing else holds the tool";
  make_slide<3>(s.state.nodes[middle], Vector<3>::UnitX());
  relieve_vertices(model, s.state);
  EXPECT_TRUE(s.state.nodes[bearing].bears) << "a node that slides does not";
  make_stick(s.state.nodes[middle]);
  relieve_vertices(model, s.state);
  EXPECT_FALSE(s.state.nodes[bearing].bears);
  EXPECT_STREQ(name_of(s.state.nodes[bearing].state), "sliding");
  EXPECT_TRUE(s.state.nodes[bearing].slip_direction.isZero());
  EXPECT_STREQ(name_of(s.state.nodes[middle].state), "sticking");
}

// Half of a body: the traction across the plane of symmetry is zero on it, the one along it what it is.
TEST(WeightlessVertices, TractionOnAPlaneOfSymmetry) {
  PlaneOnBlock s(10, true);
  const auto& model = s.setup.model();
  s.load([](const Vector<3>&) { return 2.; });
  for (const int node : model.candidates) {
    const double N = -s.R[3 * node + 2];
    s.R.segment<2>(3 * node) << 0.2 * N, 0.1 * N;
  }
  const SurfaceReport<3> report = surface_report(model, s.setup.body(), s.state, s.mesh.facets, s.u, s.R);
  for (int i = 0; i < static_cast<int>(s.state.nodes.size()); ++i) {
    if (!model.is_weightless(i)) continue;
    const bool on_plane = s.mesh.node(model.candidates[i])[1] < 1e-9;
    EXPECT_NEAR(report.traction_tangential(0, i), 0.4, 1e-13);
    if (on_plane) {
      EXPECT_EQ(report.traction_tangential(1, i), 0);
    } else {
      EXPECT_GE(report.traction_tangential(1, i), 0.1);
    }
  }
}

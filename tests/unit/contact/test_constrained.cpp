// Nodes on symmetry lines, tools that may touch some candidates only, and bodies with free rigid motions.
#include "contact/linearization.hpp"
#include "unit/contact/event_scene.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

BodyView<2> square_body(std::vector<char> fixed) {
  BodyView<2> body;
  body.X.resize(8);
  body.X << 0, 0, 1, 0, 1, 1, 0, 1;
  body.fixed = std::move(fixed);
  return body;
}

/// Node 2 held along x under a roller whose normal there leans by 30 degrees.
EventScene constrained_scene() {
  EventScene scene;
  scene.add(std::make_shared<Circle>(1.), Vector<3>(2 - 0.5, std::sqrt(0.75), 0), 0.3);
  scene.model.constrained.assign(EventScene::NODES, {false, false});
  scene.model.constrained[2] = {true, false};
  scene.touch(2, NodeState::SLIDING, 0);
  return scene;
}

} // namespace

TEST(RigidMotions, ConstrainedOrFree) {
  EXPECT_FALSE(constrains_rigid_motions(square_body({0, 0, 0, 0, 0, 0, 0, 0})));
  EXPECT_FALSE(constrains_rigid_motions(square_body({1, 0, 0, 0, 0, 0, 1, 0}))) << "free along y";
  EXPECT_FALSE(constrains_rigid_motions(square_body({1, 1, 0, 0, 0, 0, 0, 0})))
      << "free to turn about node 0";
  EXPECT_TRUE(constrains_rigid_motions(square_body({1, 1, 0, 1, 0, 0, 0, 0})));
  EXPECT_TRUE(constrains_rigid_motions(square_body({1, 0, 0, 0, 0, 0, 1, 1})));
}

TEST(Constrained, ForceAlongTheNormalFromTheFreeComponent) {
  const EventScene scene = constrained_scene();
  const auto p = scene.model.tools[0]->point(scene.start.q, scene.start.nodes[2].place);
  const auto force = nodal_force<2>(scene.model, 2, p, Vector<2>(123, -5));
  EXPECT_NEAR(force.part.N, -5 / p.n.y(), 1e-12);
  EXPECT_NEAR((force.F - force.part.N * p.n).norm(), 0, 1e-12);
  EXPECT_EQ(force.part.T[0], 0);
  const auto other = nodal_force<2>(scene.model, 3, p, Vector<2>(1, -5));
  EXPECT_NEAR(other.part.N, Vector<2>(1, -5).dot(p.n), 1e-12);
  EXPECT_NEAR(other.part.T[0], Vector<2>(1, -5).dot(Vector<2>(p.E)), 1e-12);
  EXPECT_TRUE(scene.model.law(2, 0).frictionless());
  EXPECT_FALSE(scene.model.law(3, 0).frictionless());
}

// The node follows the tool along the free component only, so that the gap stays closed to first order; the
// generalized force by those columns is that of the force N n.
TEST(Constrained, ColumnsKeepTheGapClosed) {
  const EventScene scene = constrained_scene();
  const auto poses = scene.model.poses(scene.start.q);
  const Vector<2> R(7, -5);
  const auto linear =
      linearize_node(scene.model, scene.start.nodes[2], 2, poses, R, GeometricTerms::COMPLETE);
  EXPECT_FALSE(linear.sliding);
  const Vector<2> x = scene.body.position(scene.u0, 2);
  const double h = 1e-5;
  for (int k = 0; k < 3; ++k) {
    const Vector<2> du = linear.x_q.col(k);
    EXPECT_EQ(du.x(), 0);
    const auto gap = [&](double step) {
      Eigen::VectorXd q = scene.start.q;
      q[k] += step;
      const Vector<2> moved = x + step * du;
      return scene.model.tools[0]->foot(scene.model.poses(q)[0], moved, scene.start.nodes[2].place.hint).gap;
    };
    EXPECT_NEAR((gap(h) - gap(-h)) / (2 * h), 0, 1e-9) << "coordinate " << k;
    const auto force = nodal_force<2>(scene.model, 2, linear.point, R);
    EXPECT_NEAR(du.dot(R), linear.point.x_q.col(k).dot(force.F), 1e-12) << "coordinate " << k;
  }
}

TEST(Constrained, NothingPressesAcrossTheFreeComponent) {
  EventScene scene = constrained_scene();
  EXPECT_TRUE(admissible_normal<2>(scene.model, 2, Vector<2>(1, 0)).isZero());
  EXPECT_EQ(admissible_normal<2>(scene.model, 3, Vector<2>(1, 0)), Vector<2>(1, 0));
}

TEST(Reach, ToolsThatMayNotTouchAreNotNear) {
  EventScene scene;
  scene.add_plate(0.1, 0);
  scene.add_plate(0.5, 0);
  scene.model.reach = {std::vector<char>(EventScene::NODES, 0), {}};
  scene.model.reach[0][1] = 1;
  const auto poses = scene.model.poses(scene.start.q);
  const ContactNode<2> any;
  EXPECT_EQ(nearest_tool<2>(scene.model, poses, Vector<2>(0, 0), any, 1).tool, 0);
  EXPECT_EQ(nearest_tool<2>(scene.model, poses, Vector<2>(0, 0), any, 2).tool, 1);
  EXPECT_EQ(nearest_tool<2>(scene.model, poses, Vector<2>(0, 0), any, -1).tool, 0);
  scene.model.reach[1].assign(EventScene::NODES, 0);
  EXPECT_EQ(nearest_tool<2>(scene.model, poses, Vector<2>(0, 0), any, 2).tool, -1);
  EXPECT_GT(nearest_tool<2>(scene.model, poses, Vector<2>(0, 0), any, 2).foot.gap, 1e300);
}

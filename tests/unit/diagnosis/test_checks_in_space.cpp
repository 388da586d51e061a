// What is checked of accepted steps in space: tools between the nodes and at faces without a label, contacts of few nodes.
#include "diagnosis/accepted/boundary_edges.hpp"
#include "diagnosis/accepted/contact_width.hpp"
#include "run/seen_step.hpp"
#include "support/space_scene.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// A tool led through some places; its findings.
FindingList findings_of(SpaceScene& scene, const std::vector<Vector<3>>& places) {
  Diagnosis<3> diagnosis;
  const auto q = [](const Vector<3>& x) { return numbers({x[0], x[1], x[2], 0, 0, 0}); };
  scene.place(q(places[0]));
  scene.start();
  const Workpiece<3>& workpiece = scene.body.workpiece();
  diagnosis.begin(accepted_step(*scene.contact, &workpiece));
  for (std::size_t k = 1; k < places.size(); ++k) {
    scene.move(q(places[k]));
    scene.step(static_cast<double>(k - 1), 1);
    if (testing::Test::HasFatalFailure()) break;
    diagnosis.look(accepted_step(*scene.contact, &workpiece));
  }
  return diagnosis.findings();
}

std::shared_ptr<const Coordinates<3>> six() { return std::make_shared<CartesianInSpace>(); }

} // namespace

TEST(ChecksInSpace, BoundaryEdgesEncloseTheBody) {
  for (const bool quadratic : {false, true}) {
    const Mesh<3> linear = BlockOfTetrahedra{}.mesh();
    const Mesh<3> mesh = quadratic ? quadratic_tetrahedra(linear) : linear;
    const auto edges = boundary_edges(mesh);
    // faces F = 2 (4 4 + 2 (4 2)) 2 = 128 of a sphere: edges 3 F/2, twice as many pieces with mid nodes
    EXPECT_EQ(edges.size(), quadratic ? 384u : 192u);
    BodyView<3> body;
    body.X = Eigen::Map<const Eigen::VectorXd>(mesh.X.data(), static_cast<Eigen::Index>(mesh.X.size()));
    const Eigen::VectorXd u = Eigen::VectorXd::Zero(body.X.size());
    for (const auto& edge : edges) {
      const Vector<3> middle = 0.5 * (mesh.node(edge.a) + mesh.node(edge.b)), out = outward(body, u, edge);
      EXPECT_GT(out.norm(), 1);
      EXPECT_GT(out.dot(middle - Vector<3>(0, 0, -0.5)), 0);
    }
  }
}

TEST(ChecksInSpace, ABallBetweenTheNodes) { // of edges of 0.5 along x, none of its nodes touches
  SpaceScene scene({}, sphere(0.2), six(), 0.3);
  const FindingList found = findings_of(scene, {{0.25, 0, 0.3}, {0.25, 0, 0.12}});
  ASSERT_FALSE(HasFatalFailure());
  ASSERT_TRUE(found.holds("edge depth", "tool"));
  EXPECT_NEAR(found.measured().at("edge depth"), 0.08 / 0.5, 1e-3);
  EXPECT_EQ(found.measured().at("overlap"), 0);
}

TEST(ChecksInSpace, ABallInAFaceWithoutALabel) { // the side x = 1
  SpaceScene scene({}, sphere(0.2), six(), 0.3);
  const FindingList found = findings_of(scene, {{1.5, 0, -0.25}, {1.1, 0, -0.25}});
  ASSERT_FALSE(HasFatalFailure());
  ASSERT_TRUE(found.holds("overlap", "tool"));
  EXPECT_NEAR(found.measured().at("overlap"), 0.1 / 0.5, 1e-3);
  EXPECT_FALSE(found.trusted());
}

// A large ball over 3 x 3 nodes (4 across their diagonal), and a roll that reaches over the block: as many nodes as lie across.
TEST(ChecksInSpace, ContactsOfFewNodes) {
  SpaceScene ball({}, sphere(4), six(), 0.3);
  const FindingList few = findings_of(ball, {{0, 0, 4}, {0, 0, 3.9}});
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_TRUE(few.holds("contact width", "tool"));
  EXPECT_GE(few.measured().at("contact nodes tool"), 3);
  EXPECT_LE(few.measured().at("contact nodes tool"), 4);
  BlockOfTetrahedra fine;
  fine.nx = 10;
  fine.lx = 1;
  const AxisFrame along_y = axis_frame("test", {0, -4, 0}, {0, 1, 0});
  SpaceScene roll(fine, cylinder(4, 8, along_y), six(), 0.3);
  const FindingList enough = findings_of(roll, {{0, 0, 4}, {0, 0, 3.97}});
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_FALSE(enough.holds("contact width", "tool"));
  EXPECT_GE(enough.measured().at("contact nodes tool"), 5);
  EXPECT_EQ(few_nodes(BlockOfTetrahedra{}.mesh()), 4);
}

// Plastic strain beyond the range of the Jaumann rate is told in space, too.
TEST(ChecksInSpace, RangeOfTheJaumannRate) {
  SpaceScene scene({}, std::make_shared<PlaneSurface>(Vector<3>(0, 0, 0), Vector<3>(0, 0, -1), 4), six(), 0);
  Diagnosis<3> diagnosis;
  scene.place(numbers({0, 0, 0, 0, 0, 0}));
  scene.start();
  const Workpiece<3>& workpiece = scene.body.workpiece();
  diagnosis.begin(accepted_step(*scene.contact, &workpiece));
  for (int k = 1; k <= 6; ++k) {
    scene.move(numbers({0, 0, -0.03 * k, 0, 0, 0}));
    scene.step(k - 1., 1);
    ASSERT_FALSE(HasFatalFailure());
    AcceptedStep<3> step = accepted_step(*scene.contact, &workpiece);
    step.last = k == 6;
    diagnosis.look(step);
  }
  bool told = false;
  for (const Finding& finding : diagnosis.findings().list())
    told = told || finding.text.find("Jaumann") != std::string::npos;
  EXPECT_TRUE(told) << "elastic strains of some tenths";
}

namespace {

/// The last step with other forces, held to another load and tolerance.
FindingList findings_with(const SpaceScene& scene, const Eigen::VectorXd& R, double load, double tolerance) {
  const AcceptedStep<3> step = accepted_step<3>(*scene.contact, nullptr);
  AcceptedStep<3> changed{step.setup, step.contact, step.u, R, step.generalized_force};
  changed.allowed = {load, tolerance, step.allowed.rounding, step.allowed.offset};
  changed.prescribed = step.prescribed;
  changed.last = true;
  Diagnosis<3> diagnosis;
  diagnosis.begin(step);
  diagnosis.look(changed);
  return diagnosis.findings();
}

std::string text_of(const FindingList& findings, const std::string& check) {
  for (const Finding& finding : findings.list())
    if (finding.check == check) return finding.text;
  return "";
}

} // namespace

// A plane slides over 5 x 5 nodes. Friction 3 % beyond its limit is .003 of the normal force; by their tolerances the nodes may
// miss .025, or .00025, which only a scheme can have exceeded. Forces far below rounding are no load.
TEST(ChecksInSpace, WhatTheToleranceAllowsManyNodes) {
  SpaceScene scene({}, std::make_shared<PlaneSurface>(Vector<3>(0, 0, 0), Vector<3>(0, 0, -1), 4), six(),
                   0.1);
  scene.place(numbers({0, 0, 0, 0, 0, 0}));
  scene.start();
  for (int k = 1; k <= 3; ++k) {
    scene.move(numbers({k > 1 ? 0.05 * k : 0, 0, -0.01, 0, 0, 0}));
    scene.step(k - 1., 1);
    ASSERT_FALSE(HasFatalFailure());
  }
  double load = 0;
  Eigen::VectorXd R = scene.R, none = Eigen::VectorXd::Zero(R.size());
  for (const int a : scene.setup->candidates()) {
    load += R.segment<3>(3 * a).norm();
    R.segment<2>(3 * a) *= 1.03;
  }
  EXPECT_EQ(text_of(findings_with(scene, scene.R, load, 1e-3), "friction sum"), "");
  const std::string many = text_of(findings_with(scene, R, load, 1e-3), "friction sum"),
                    lost = text_of(findings_with(scene, R, load, 1e-5), "friction sum");
  EXPECT_NE(many.find("take a smaller tolerance="), std::string::npos) << many;
  EXPECT_NE(lost.find("does not come back to equilibrium"), std::string::npos) << lost;

  int inside = 0; // a node that nothing holds
  while (scene.mesh.node(inside).norm() > 0.6 || scene.mesh.node(inside)[2] > -0.4) ++inside;
  none[3 * inside] = 1e-27;
  EXPECT_EQ(text_of(findings_with(scene, none, 1e-28, 1e-4), "residual"), "");
  EXPECT_NE(text_of(findings_with(scene, none * 1e27, 0.1, 1e-4), "residual"), "");
}

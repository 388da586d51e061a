// The list of findings, and every self-check on a state that violates it and on one that does not.
#include "diagnosis/accepted/boundary_edges.hpp"
#include "diagnosis/accepted/tool_depth.hpp"
#include "diagnosis/diagnosis.hpp"
#include "support/run.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Block 4 x 1.5 under a rough roller that has pressed and turned.
struct Pressed : Scene {
  explicit Pressed(J2Parameters material = elastic_material())
      : Scene(block_mesh(24, 6, 2, 4, 1.5), std::move(material), {}) {
    add_tool(std::make_shared<Circle>(3.), std::make_shared<Cartesian>(), 0.3);
    place({1.7, 4.9, 0});
    contact().approach(0, "y", u);
    for (int step = 1; step <= 3; ++step) {
      tool->prescription().move("x", 1.7 + 0.05 * step);
      tool->prescription().move("y", 4.5 - 0.02 * step);
      tool->prescription().move("angle", -0.01 * step);
      EXPECT_EQ(converge(*this, step, 1, Stepping::IMPLICIT), StepStatus::CONVERGED) << why();
      accept(*this, {});
    }
  }
  /// As if (u, R) had been accepted in the last step.
  FindingList look(const Eigen::VectorXd& displacement, const Eigen::VectorXd& residual) {
    diagnosis = {};
    return look_again(displacement, residual);
  }
  FindingList look_again(const Eigen::VectorXd& displacement, const Eigen::VectorXd& residual) {
    const auto& state = contact().accepted();
    AcceptedStep<2> step{contact().setup(), state.contact,           displacement,
                         residual,          state.generalized_force, &workpiece()};
    step.allowed.load = contact().iteration().balance().memory().scale;
    step.allowed.relative = 1e-4;
    step.t = 1; // of no length: no energy is added
    step.last = true;
    step.prescribed = prescribed;
    diagnosis.begin(step);
    stop = diagnosis.look(step);
    return diagnosis.findings();
  }
  FindingList look() { return look(contact().accepted().u, contact().accepted().R); }
  double measured(const std::string& name) const { return diagnosis.findings().measured().at(name); }
  std::string stop;
  const PrescribedValues* prescribed = nullptr;
};

const Finding* find(const FindingList& findings, const std::string& check, const std::string& subject = "") {
  for (const Finding& finding : findings.list())
    if (finding.check == check && (subject.empty() || finding.subject == subject)) return &finding;
  return nullptr;
}

} // namespace

TEST(FindingList, KeepsTheWorstOfAPairAndTheInstantOfTheFirst) {
  FindingList findings;
  EXPECT_TRUE(findings.trusted());
  EXPECT_EQ(findings.worst(), nullptr);
  ASSERT_TRUE(findings.report("a", "x", Severity::WARNING, 2, 0.1));
  EXPECT_FALSE(findings.report("a", "x", Severity::WARNING, 2, 0.2)) << "no worse";
  EXPECT_FALSE(findings.report("a", "x", Severity::NOTE, 9, 0.3)) << "less severe";
  ASSERT_TRUE(findings.report("a", "x", Severity::WARNING, 3, 0.4));
  ASSERT_TRUE(findings.report("a", "y", Severity::WARNING, 1, 0.5)) << "another subject";
  EXPECT_TRUE(findings.trusted());
  ASSERT_TRUE(findings.report("a", "x", Severity::UNTRUSTED, 1, 0.6)) << "more severe";
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].count, 5);
  EXPECT_EQ(findings[0].first, 0.1);
  EXPECT_EQ(findings[0].t, 0.6);
  EXPECT_FALSE(findings.trusted());
  EXPECT_EQ(findings.worst(), &findings[0]);
  findings.withdraw("a", "x");
  EXPECT_TRUE(findings.trusted());
  EXPECT_EQ(findings.size(), 1u);
}

// A circle of radius 3 whose lowest point is 0.1 below an edge, between its ends; then beyond them, and above.
TEST(ToolDepth, IsThatOfTheClosestApproach) {
  const Tool<2> tool("roller", std::make_shared<ProfileSurface>(std::make_shared<Circle>(3.)),
                     std::make_shared<Cartesian>());
  const Vector<2> a(-0.5, 0), b(0.5, 0);
  const auto depth = [&](double x, double y) {
    return tool_depth(tool, tool.coordinates().pose(Eigen::Vector3d(x, y, 0)), a, b, Param<2>::Zero());
  };
  EXPECT_NEAR(depth(0.13, 2.9).depth, 0.1, 1e-6);
  EXPECT_NEAR(depth(0.13, 2.9).x[0], 0.13, 1e-3);
  EXPECT_NEAR(depth(0.13, 3.2).depth, -0.2, 1e-6);
  EXPECT_NEAR(depth(2.5, 2.9).depth, 3 - std::hypot(2., 2.9), 1e-12) << "at an end";
  EXPECT_NEAR(depth(0, 2.9).n[1], -1, 1e-6);
}

TEST(BoundaryEdges, GoRoundTheBodyWithTheBodyOnTheLeft) {
  const ContactMesh mesh = block_mesh(3, 2, 2, 3, 2);
  double area = 0;
  const auto edges = boundary_edges(mesh.space);
  EXPECT_EQ(edges.size(), 2u * (3 + 2 + 3 + 2));
  for (const BoundaryEdge<2>& edge : edges) {
    const Vector<2> a = mesh.space.node(edge.a), b = mesh.space.node(edge.b);
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  EXPECT_NEAR(area, 6, 1e-12);
}

TEST(RunChecks, AGoodStepHasNothingToReport) {
  Pressed scene;
  const FindingList findings = scene.look();
  for (const Finding& finding : findings.list()) ADD_FAILURE() << finding.check << ": " << finding.text;
  EXPECT_LT(scene.measured("balance"), 2e-3);
  EXPECT_EQ(scene.measured("tension"), 0);
  EXPECT_GT(scene.measured("determinant"), 0.5);
}

TEST(RunChecks, ForceThatNothingCarries) {
  Pressed scene;
  const auto& state = scene.contact().accepted();
  Eigen::VectorXd R = state.R;
  int free = 0; // a node inside: neither held nor a candidate
  const auto& model = scene.contact().setup().model();
  const auto candidate = candidate_of_node(model.candidates, scene.contact().setup().mesh().num_nodes);
  while (scene.contact().setup().body().fixed[2 * free] || candidate[free] >= 0) ++free;
  R[2 * free + 1] += 0.1 * scene.contact().iteration().balance().memory().scale;
  const FindingList findings = scene.look(state.u, R);
  ASSERT_TRUE(find(findings, "balance"));
  EXPECT_NEAR(find(findings, "balance")->value, 0.1, 0.01);
  ASSERT_TRUE(find(findings, "residual"));
  EXPECT_NEAR(find(findings, "residual")->value, 0.1, 0.01);
  EXPECT_FALSE(findings.trusted());
}

// The force along y was met exactly; then it is said to have been 2 % and 10 % more.
TEST(RunChecks, PrescribedForceThatIsMissed) {
  Pressed scene;
  const auto& state = scene.contact().accepted();
  PrescribedValues prescribed = state.prescribed;
  scene.prescribed = &prescribed;
  prescribed.is_motion[1] = 0;
  for (const double more : {0., 0.02, 0.1}) {
    prescribed.value[1] = (1 + more) * state.generalized_force[1];
    const FindingList findings = scene.look(state.u, state.R);
    const Finding* finding = find(findings, "unmet force");
    EXPECT_EQ(finding != nullptr, more > 0) << more;
    if (!finding) continue;
    EXPECT_NEAR(finding->value, more / (1 + more), 1e-3);
    EXPECT_EQ(finding->severity, more > 0.05 ? Severity::UNTRUSTED : Severity::WARNING);
    EXPECT_NE(finding->text.find("coordinate \"y\" of tool"), std::string::npos) << finding->text;
  }
}

// At the end of an event step a node has touched whose force was held to another tool's tolerance.
TEST(RunChecks, PrescribedForceBesideEventsOfTheEnd) {
  Pressed scene;
  const auto& state = scene.contact().accepted();
  PrescribedValues prescribed = state.prescribed;
  scene.prescribed = &prescribed;
  prescribed.is_motion[1] = 0;
  prescribed.value[1] = state.generalized_force[1];
  Eigen::VectorXd R = state.R;
  for (std::size_t i = 0; i < state.contact.nodes.size(); ++i)
    if (in_contact(state.contact.nodes[i].state))
      R[2 * scene.contact().setup().model().candidates[i] + 1] -=
          0.1 * scene.contact().iteration().balance().memory().scale;
  EXPECT_FALSE(find(scene.look(state.u, R), "unmet force"));
}

TEST(RunChecks, ToolThatPulls) {
  Pressed scene;
  const auto& state = scene.contact().accepted();
  const Finding* finding = nullptr;
  const FindingList findings = scene.look(state.u, -state.R);
  ASSERT_TRUE(finding = find(findings, "tension"));
  EXPECT_EQ(finding->severity, Severity::UNTRUSTED);
  EXPECT_GT(finding->value, 0.1);
  EXPECT_TRUE(find(findings, "friction")) << "beyond its limit, which is none";
}

// The tool's force does work over a way that nobody takes.
TEST(RunChecks, EnergyFromNowhere) {
  Pressed scene;
  const auto& accepted = scene.contact().accepted();
  EXPECT_FALSE(find(scene.look(), "energy"));
  ContactRunState<2> state = scene.contact().state();
  state.contact.q[1] += 0.5; // the next look sees the tool higher up, the body where it was
  scene.contact().set_state(state);
  const FindingList findings = scene.look_again(accepted.u, accepted.R);
  ASSERT_TRUE(find(findings, "energy"));
  EXPECT_GT(find(findings, "energy")->value, 0.5);
}

TEST(RunChecks, AnAngleInDegrees) {
  Pressed scene;
  const auto& accepted = scene.contact().accepted();
  scene.prescribed = &scene.contact().step().prescribed;
  EXPECT_FALSE(find(scene.look(), "turning"));
  ContactRunState<2> state = scene.contact().state();
  state.contact.q[2] -= 0.6; // the next look sees the tool turned
  scene.contact().set_state(state);
  const FindingList findings = scene.look_again(accepted.u, accepted.R);
  ASSERT_TRUE(find(findings, "turning"));
  EXPECT_NEAR(find(findings, "turning")->value, 0.6, 1e-12);
  EXPECT_EQ(find(findings, "turning")->severity, Severity::WARNING);
}

TEST(RunChecks, InvertedElementEndsTheRunAndADistortedOneIsNotTrusted) {
  Pressed scene;
  const auto& state = scene.contact().accepted();
  const auto& mesh = scene.contact().setup().mesh();
  const int* element = mesh.element(0);
  // vertex 0 alone moves towards the opposite edge: its Jacobian falls to 1 - 3 part
  const auto moved = [&](double part) {
    Eigen::VectorXd u = state.u;
    const Vector<2> way = 0.5 * (mesh.node(element[1]) + mesh.node(element[2])) - mesh.node(element[0]);
    u.segment<2>(2 * element[0]) += part * way;
    return u;
  };
  const FindingList good = scene.look(moved(0.02), state.R);
  EXPECT_FALSE(find(good, "distortion"));
  const FindingList bad = scene.look(moved(0.31), state.R);
  ASSERT_TRUE(find(bad, "distortion"));
  EXPECT_EQ(find(bad, "distortion")->severity, Severity::UNTRUSTED);
  EXPECT_TRUE(scene.stop.empty());
  const FindingList worse = scene.look(moved(0.9), state.R);
  ASSERT_TRUE(find(worse, "distortion"));
  EXPECT_EQ(find(worse, "distortion")->severity, Severity::STOP);
  EXPECT_FALSE(scene.stop.empty());
}

TEST(RunChecks, StressBeyondTheYieldSurfaceAndVolumeOfFlow) {
  Pressed scene(J2Parameters::from_shear(1, 0.3, 0.05, 0.5));
  EXPECT_FALSE(find(scene.look(), "yield"));
  EXPECT_FALSE(find(scene.look(), "volume"));
  EXPECT_GT(scene.measured("plastic strain"), 0);
  WorkpieceState<2> state = scene.workpiece().state_old();
  for (double& stress : state.stress) stress *= 1.5;
  scene.workpiece().set_state(state);
  const FindingList findings = scene.look();
  ASSERT_TRUE(find(findings, "yield"));
  EXPECT_NEAR(find(findings, "yield")->value, 0.5, 0.01);
  EXPECT_TRUE(find(findings, "volume")) << "the stress no longer fits the volume";
}

TEST(RunChecks, VolumeOfASmallStrainFlow) {
  J2Parameters material = J2Parameters::from_shear(1, 0.3, 0.05, 0.5);
  material.rate = CorotationalRate::SMALL_STRAIN;
  Pressed scene(material);
  EXPECT_FALSE(find(scene.look(), "volume"));
  EXPECT_GT(scene.measured("plastic strain"), 0);
  EXPECT_LT(scene.measured("volume"), 1e-10) << "tr F - 3, not ln det F";
}

// Every error of a run's verbs: message, and what to do about it.
#include "diagnosis/words.hpp"
#include "support/run.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

std::shared_ptr<DrivenTool<2>> roller(const std::string& name) {
  return driven_tool(name, std::make_shared<Circle>(3.), std::make_shared<Cartesian>());
}
const auto PLANE = std::make_shared<EdgeMeasure>();

/// Block 4 x 1.5 with a roller at x = 2, its lowest point at `height` above the top.
struct Block : Scene {
  explicit Block(double mu = 0.3, double height = 0.4)
      : Scene(block_mesh(4, 2, 2, 4, 1.5), elastic_material()) {
    add_tool(std::make_shared<Circle>(3.), std::make_shared<Cartesian>(), mu);
    place({2, 4.5 + height, 0});
    drive(4.45);
  }
  void drive(double y) {
    tool->prescription().move("x", 2);
    tool->prescription().move("y", y);
    tool->prescription().move("angle", 0);
  }
  void begin(double dt = 1) { contact().begin(u, 0, dt, Stepping::IMPLICIT); }
};

} // namespace

TEST(ContactRunErrors, Construction) {
  const auto mesh = block_mesh(4, 2, 1, 4, 1.5);
  expect_invalid([&] { ContactSetup<2>(mesh.space, mesh.surface, std::vector<char>(7, 0), PLANE); },
                 "contact: number of fixed flags = 7, expected one per degree of freedom");
  const std::string none =
      "contact: number of candidate nodes = 0, expected at least one node on the labels that is not fixed";
  expect_invalid([&] { ContactSetup<2>(mesh.space, {}, mesh.fixed, PLANE); }, none);
  expect_invalid(
      [&] { ContactSetup<2>(mesh.space, mesh.surface, std::vector<char>(mesh.fixed.size(), 1), PLANE); },
      none);
}

TEST(ContactRunErrors, Tools) {
  Block block;
  expect_invalid([&] { block.setup->add_tool(roller("tool"), make_coulomb(0)); },
                 "contact.add: tool \"tool\" is already there");
  const auto bare =
      std::make_shared<DrivenTool<2>>("bare", std::make_shared<ProfileSurface>(std::make_shared<Circle>(3.)));
  expect_invalid([&] { block.setup->add_tool(bare, make_coulomb(0)); }, "\"bare\" has no coordinates yet");
  block.begin();
  expect_invalid([&] { block.setup->add_tool(roller("late"), make_coulomb(0)); },
                 "contact.add: tools must be added before the first step");
  const auto mesh = block_mesh(4, 2, 1, 4, 1.5);
  const auto empty = std::make_shared<ContactSetup<2>>(mesh.space, mesh.surface, mesh.fixed, PLANE);
  expect_invalid([&] { ContactRun<2>{empty}; }, "contact: number of tools = 0, expected at least one tool");
}

TEST(ContactRunErrors, Approach) {
  Block block;
  expect_invalid([&] { block.contact().approach(1, "y", block.u); }, "contact.approach: tool = 1");
  expect_invalid([&] { block.contact().approach(-1, "y", block.u); }, "expected a tool that was added");
  expect_invalid([&] { block.contact().approach(0, "y", Eigen::VectorXd::Zero(3)); },
                 "contact.approach: size of u = 3, expected number of dofs");
  expect_invalid([&] { block.contact().approach(0, "z", block.u); },
                 "\"tool\" has no coordinate \"z\", its coordinates are x, y, angle");
  const std::string cannot =
      "alone does not bring it to the body; place the tool opposite the contact surface";
  expect_invalid([&] { block.contact().approach(0, "angle", block.u); },
                 "contact.approach: coordinate \"angle\" of tool \"tool\" " + cannot);
  block.place({2, 50, 0});
  expect_invalid([&] { block.contact().approach(0, "x", block.u); },
                 "coordinate \"x\" of tool \"tool\" " + cannot);
  Eigen::VectorXd u = block.u;
  u[20] = std::nan("");
  expect_invalid([&] { block.contact().approach(0, "y", u); },
                 "closest_point: x = nan nan, expected finite components");
}

TEST(ContactRunErrors, Begin) {
  Block block;
  expect_invalid([&] { block.begin(0); }, "contact.begin: dt = 0, expected > 0");
  expect_invalid([&] { block.begin(-1); }, "contact.begin: dt = -1, expected > 0");
  expect_invalid([&] { block.begin(std::nan("")); }, "contact.begin: dt = nan, expected > 0");
  Eigen::VectorXd u = Eigen::VectorXd::Zero(5);
  expect_invalid([&] { block.contact().begin(u, 0, 1, Stepping::IMPLICIT); },
                 "contact.begin: size of u = 5, expected number of dofs");
  block.u[4] = std::nan("");
  expect_invalid([&] { block.begin(); }, "contact.begin: the displacement contains NaN or Inf");
  expect_invalid([&] { block.tool->prescription().move("z", 1); },
                 "tool \"tool\" has no coordinate \"z\", expected one of x, y, angle");
}

TEST(ContactRunErrors, UndrivenCoordinate) {
  Scene scene(block_mesh(4, 2, 2, 4, 1.5), elastic_material());
  scene.add_tool(std::make_shared<Circle>(3.), std::make_shared<Cartesian>(), 0.3);
  scene.place({2, 5, 0});
  scene.tool->prescription().move("x", 2);
  expect_invalid(
      [&] { scene.contact().begin(scene.u, 0, 1, Stepping::IMPLICIT); },
      "Prescription: coordinate \"y\" of tool \"tool\" has neither motion nor force; coordinate \"angle\"");
}

TEST(ContactRunErrors, ToolInsideTheBody) {
  Block block(0.3, -0.1);
  expect_invalid([&] { block.begin(); }, "contact.begin: tool \"tool\" starts inside the workpiece: node ");
  expect_invalid([&] { block.begin(); }, " at 2 1.5 penetrates by 0.1;");
  expect_invalid([&] { block.begin(); }, "; place the tool outside and call approach");
}

TEST(ContactRunErrors, ForceWithoutContact) {
  Block block;
  block.tool->prescription().force("y", -1);
  expect_invalid(
      [&] { block.begin(); },
      "contact.begin: coordinate \"y\" of tool \"tool\" is under force but the tool touches nothing, so "
      "it has no support; bring the tool into contact by motion or with approach first, or give the "
      "coordinate a motion");
  block.contact().approach(0, "y", block.u);
  EXPECT_NO_THROW(block.begin());
}

TEST(ContactRunErrors, ForceThatNothingResists) {
  Block block(0);
  block.contact().approach(0, "y", block.u);
  block.tool->prescription().force("angle", 0.1);
  expect_invalid(
      [&] { block.begin(); },
      "contact.begin: coordinate \"angle\" of tool \"tool\" has a force but without friction nothing "
      "resists it; give it a motion or friction");
}

TEST(ContactRunErrors, CheckFactorizeCorrect) {
  Block block;
  block.begin();
  expect_invalid([&] { block.contact().check(block.u, Eigen::VectorXd::Zero(4)); },
                 "contact.check: size of the force array = 4, expected number of dofs");
  Eigen::VectorXd bad = block.R;
  bad[3] = std::nan("");
  expect_invalid([&] { block.contact().check(block.u, bad); },
                 "contact.check: the force array contains NaN or Inf");
  bad[3] = INFINITY;
  expect_invalid([&] { block.contact().check(block.u, bad); }, "the force array contains NaN or Inf");
  expect_invalid([&] { block.contact().correct(block.u, block.R); },
                 "contact.correct: no factor: call factorize first");
  const auto small = pattern_from_elements<2>(3, 3, {0, 1, 2});
  expect_invalid([&] { block.contact().factorize(small, block.u); },
                 "contact.factorize: size of K = 6, expected number of dofs");
}

TEST(ContactRunErrors, OrderOfCalls) {
  Block block;
  const auto condense = [&](const Eigen::VectorXd& R) {
    block.contact().condensed().condense(block.tangent, block.u, R, GeometricTerms::COMPLETE,
                                         RightHandSide::TOTAL, false);
  };
  expect_invalid([&] { condense(block.R); }, "contact.condense: no step is under way, call begin first");
  expect_invalid([&] { block.contact().condensed().expand(block.R, block.u); },
                 "contact.expand: no step is under way, call begin first");
  block.begin();
  expect_invalid([&] { condense(Eigen::VectorXd::Zero(4)); },
                 "contact.condense: size of the arrays = 4, expected number of dofs");
  Eigen::VectorXd bad = block.R;
  bad[3] = std::nan("");
  expect_invalid([&] { condense(bad); }, "contact.condense: the force array contains NaN or Inf");
  Eigen::VectorXd u = Eigen::VectorXd::Zero(5);
  expect_invalid([&] { block.contact().condensed().expand(block.R, u); }, "contact.expand: size of u = 5");
  expect_invalid([&] { block.contact().accept(block.u, block.R, {}); },
                 "contact.accept: this step has not been checked, call check first");
  block.contact().check(block.u, block.R);
  expect_invalid([&] { block.contact().accept(u, block.R, {}); },
                 "contact.accept: size of the arrays = 5, expected number of dofs");
  expect_invalid([&] { block.contact().accept(block.u, u, {}); }, "contact.accept: size of the arrays");
}

// A tangent that stays indefinite: the corrector says so after four attempts.
TEST(ContactRunErrors, IndefiniteTangent) {
  Block block;
  block.begin();
  ASSERT_EQ(block.workpiece().update(block.u, 1, 0).status, UpdateStatus::OK);
  block.workpiece().tangent(block.tangent, TangentKind::ELASTIC);
  for (double& value : block.tangent.value) value = -value;
  auto& iteration = block.contact().iteration();
  for (int attempt = 0; attempt < 4; ++attempt) {
    EXPECT_FALSE(iteration.policy().blend_exhausted());
    EXPECT_EQ(block.contact().factorize(block.tangent, block.u), FactorStatus::NOT_POSITIVE_DEFINITE);
    EXPECT_GT(iteration.policy().elastic_blend(), 0);
  }
  EXPECT_TRUE(iteration.policy().blend_exhausted());
  EXPECT_EQ(words(iteration.failure(), block.contact().setup().model()),
            "the tangent is not positive definite: loss of stability or limit load");
}

TEST(ContactRunErrors, NoConvergenceSaysHowFarItCame) {
  Block block;
  block.contact().approach(0, "y", block.u);
  block.contact().iteration().options().max_iterations = 0;
  EXPECT_EQ(converge(block, 0, 1, Stepping::IMPLICIT), StepStatus::FAILED);
  EXPECT_EQ(block.why().find("no convergence in "), 0u) << block.why();
}

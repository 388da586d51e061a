// What the scene report is made of: recovered stress, percentile, steps too fine, and a state that goes on.
#include "diagnosis/diagnosis.hpp"
#include "support/run.hpp"
#include "workpiece/stress_error.hpp"
#include "workpiece/volume_percentile.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Block 4 x 1.5 under a rough roller.
struct Reported : Scene {
  explicit Reported(bool near = true) : Scene(block_mesh(8, 3, 2, 4, 1.5), elastic_material(), {}) {
    add_tool(std::make_shared<Circle>(3.), std::make_shared<Cartesian>(), 0.3);
    place({1.7, 4.9, 0});
    if (near) contact().approach(0, "y", u);
  }
  void press(int step, double height = 4.5) {
    tool->prescription().move("x", 1.7 + 0.05 * step);
    tool->prescription().move("y", height - 0.02 * step);
    tool->prescription().move("angle", -0.01 * step);
    EXPECT_EQ(converge(*this, step, 1, Stepping::IMPLICIT), StepStatus::CONVERGED) << why();
    accept(*this, {});
  }
  AcceptedStep<2> step() {
    AcceptedStep<2> step = accepted_step<2>(contact(), &workpiece());
    step.allowed.relative = 1e-4;
    return step;
  }
};

const Statement* find(const std::vector<Statement>& list, const std::string& name) {
  for (const Statement& statement : list)
    if (statement.name == name) return &statement;
  return nullptr;
}

} // namespace

TEST(SceneReport, StepsTooFineAreSaidWhereTheirErrorIsKnown) {
  Reported scene;
  scene.diagnosis.begin(scene.step());
  EXPECT_TRUE(scene.diagnosis.report(scene.step(), {}).empty()) << "before the first step";
  scene.press(1);
  scene.diagnosis.look(scene.step());
  const auto with = [&](double error, double asked, bool longest = true) {
    return scene.diagnosis.report(scene.step(), StepAccuracy{error, asked, false, longest});
  };
  EXPECT_EQ(find(with(Finding::NONE, 1e-2), "steps"), nullptr);
  EXPECT_EQ(find(with(2e-3, 1e-2), "steps"), nullptr);
  EXPECT_EQ(find(with(5e-4, 1e-2, false), "steps"), nullptr) << "something else keeps them short";
  const auto said = with(5e-4, 1e-2);
  const Statement* steps = find(said, "steps");
  ASSERT_NE(steps, nullptr);
  EXPECT_NEAR(steps->value, 0.05, 1e-12);
  EXPECT_EQ(name_of(steps->kind), std::string("modelled and not needed"));
  for (std::size_t i = 1; i < said.size(); ++i) EXPECT_GE(said[i - 1].importance, said[i].importance);
  scene.diagnosis.set_checks(false);
  EXPECT_TRUE(with(5e-4, 1e-2).empty());
}

TEST(SceneReport, NamesAToolThatTouchesNothing) {
  Reported scene(false);
  scene.diagnosis.begin(scene.step());
  scene.press(1, 4.9);
  scene.diagnosis.look(scene.step());
  EXPECT_NE(find(scene.diagnosis.report(scene.step(), {}), "tool tool"), nullptr);
  scene.press(2);
  scene.diagnosis.look(scene.step());
  EXPECT_EQ(find(scene.diagnosis.report(scene.step(), {}), "tool tool"), nullptr);
}

// What every observer remembers goes along: findings, measured numbers and statements are those of one that saw all.
TEST(Diagnosis, GoesOnFromACopy) {
  Reported scene;
  Diagnosis<2>& whole = scene.diagnosis;
  whole.begin(scene.step());
  scene.press(1);
  whole.look(scene.step());
  Diagnosis<2> copy = whole;
  scene.press(2);
  AcceptedStep<2> last = scene.step();
  last.last = true;
  whole.look(last);
  copy.look(last);
  EXPECT_EQ(whole.findings().measured(), copy.findings().measured());
  EXPECT_GT(whole.findings().measured().at("determinant"), 0.5);
  ASSERT_EQ(whole.findings().size(), copy.findings().size());
  for (std::size_t i = 0; i < copy.findings().size(); ++i)
    EXPECT_EQ(whole.findings()[i].text, copy.findings()[i].text);
  const auto a = whole.report(last, {}), b = copy.report(last, {});
  ASSERT_EQ(a.size(), b.size());
  EXPECT_GE(a.size(), 2u);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].text, b[i].text);
  Diagnosis<2> late;
  late.begin(scene.step());
  late.look(last);
  EXPECT_NE(whole.findings().measured(), late.findings().measured()) << "the energy of the first step";
}

TEST(StressError, VanishesForALinearFieldOnlyAndNamesTheWorstElement) {
  const Discretization<2> mesh = block_mesh(6, 4, 2, 3, 2).space;
  std::vector<double> stress(static_cast<std::size_t>(mesh.num_points()) * 4, 0.);
  for (int p = 0; p < mesh.num_points(); ++p)
    stress[4 * p + 1] = 2 + mesh.point[2 * p] - 3 * mesh.point[2 * p + 1];
  EXPECT_LT(stress_error(mesh, stress).relative, 1e-12);
  for (int q = 0; q < 3; ++q) stress[4 * (3 * 7 + q) + 3] = 5;
  const StressError error = stress_error(mesh, stress);
  EXPECT_EQ(error.worst, 7);
  EXPECT_GT(error.relative, 0.1);
  EXPECT_GT(error.point.segment<3>(21).minCoeff(), 1);
  stress.pop_back();
  EXPECT_THROW(stress_error(mesh, stress), std::invalid_argument);
}

TEST(VolumePercentile, CountsTheVolumeAboveTheLeastValue) {
  const Discretization<2> mesh = block_mesh(10, 1, 1, 10, 1).space; // 20 elements of one size
  Eigen::VectorXd values(20);
  for (int e = 0; e < 20; ++e) values[e] = e;
  EXPECT_EQ(volume_percentile(mesh, values, 1, 0.5), 19);
  EXPECT_EQ(volume_percentile(mesh, values, 0.49, -1), 9);
  EXPECT_EQ(volume_percentile(mesh, values, 0.49, 9.5), 14);
  EXPECT_EQ(volume_percentile(mesh, values, 0.5, 99), 0);
  EXPECT_THROW(volume_percentile(mesh, values, 1.5, 0), std::invalid_argument);
}

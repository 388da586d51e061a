// Supports that move: the step puts them where they belong, goes back with them, and a saved run goes on to the same bits.
#include "run/force_balance.hpp"
#include "support/run.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Block 4 x 1.5 clamped below, roller above it at rest; the support pushes it up.
struct Lifted : Scene {
  Lifted() : Scene(block_mesh(12, 4, 2, 4, 1.5), elastic_material(), tight()) {
    add_tool(std::make_shared<Circle>(3.), std::make_shared<Cartesian>(), 0.3);
    place({1.7, 4.9, 0});
    contact().approach(0, "y", u);
  }
  static IterationOptions tight() {
    IterationOptions options;
    options.tolerance = 1e-10;
    return options;
  }
  Eigen::VectorXd lift(double by) {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(u.size());
    for (Eigen::Index d = 1; d < u.size(); d += 2)
      if (contact().setup().body().fixed[d]) values[d] = by;
    return values;
  }
  ProgramAt program(double rate) {
    return [this, rate](double t) {
      for (const char* name : {"x", "y", "angle"})
        tool->prescription().move(name, tool->q()[tool->index(name)]);
      contact().loads().supports.prescribe(lift(rate * t));
    };
  }
};

StepControl steps() {
  StepControlOptions control;
  control.dt_max = 0.1;
  return StepControl(0, control);
}

} // namespace

TEST(Supports, RefuseFreeComponentsNaNAndSize) {
  Lifted scene;
  Eigen::VectorXd values = scene.lift(0.1);
  const auto refused = [&](const Eigen::VectorXd& v, const char* words) {
    try {
      scene.contact().loads().supports.prescribe(v);
      ADD_FAILURE() << "taken: " << words;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const int top = 2 * scene.contact().setup().candidates()[0];
  values[top] = 1e-3;
  refused(values, "this component is free");
  values[top] = 0;
  refused(values.head(4), "size of the values = 4");
  values[1] = NAN;
  refused(values, "expected a finite number");
  EXPECT_EQ(scene.contact().loads().supports.displacement().size(), 0); // nothing has changed
}

TEST(Supports, EveryPieceEndsOnTheLawAndTheSupportCarriesTheTool) {
  for (const Scheme scheme : {Scheme::IMPLICIT, Scheme::EVENT}) {
    Lifted scene;
    StepperOptions options;
    options.scheme = scheme;
    Stepper<2> stepper(scene.contact(), scene.body, scene.diagnosis, steps(), options);
    double target = 0;
    int pieces = 0;
    const ProgramAt set = scene.program(0.05), program = [&](double t) { set(target = t); };
    ASSERT_EQ(run(scene, stepper, program,
                  [&] {
                    ++pieces;
                    EXPECT_EQ(scene.contact().accepted().u[1], 0.05 * target);
                  }),
              Task::FINISHED)
        << stepper.reason();
    EXPECT_GE(pieces, 10);
    const ForceBalance<2> forces(scene.contact(), {0, 0});
    const double up = forces.reaction().force[1];
    EXPECT_GT(up, 1e-2);
    EXPECT_NEAR(forces.contact_force(0).force[1], -up, 1e-8 * up);
  }
}

TEST(Supports, ASavedRunGoesOnToTheSameBits) {
  Lifted one, other;
  Stepper<2> first(one.contact(), one.body, one.diagnosis, steps(), {}),
      second(other.contact(), other.body, other.diagnosis, steps(), {});
  const ProgramAt program = one.program(0.05);
  while (first.counts().steps < 5) {
    const Task task = first.next(one.u, one.R);
    answer(task, one, first, program);
  }
  second.set_state(first.state(), other.u, other.R);
  EXPECT_EQ(other.contact().loads().supports.displacement(), one.contact().loads().supports.displacement());
  ASSERT_EQ(run(one, first, program), Task::FINISHED);
  ASSERT_EQ(run(other, second, other.program(0.05)), Task::FINISHED);
  EXPECT_EQ(one.u, other.u);
}

TEST(Supports, PureRatesRefuseThem) {
  Lifted scene;
  scene.program(0.05)(1);
  EXPECT_THROW(scene.contact().begin(scene.u, 0, 1, Stepping::RATES), std::invalid_argument);
}

// A whole run in space through the same stepper, corrector and contact as in the plane: a plane comes down on a prism
// and is drawn along. Only the law and the measure of triangles are made by hand.
#include "contact/tributary_area.hpp"
#include "kinematics/cartesian_in_space.hpp"
#include "run/stepper.hpp"
#include "run/workpiece_tangent.hpp"
#include "support/pressed_body.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

using Program = std::function<void(Prescription&, double t)>;

Task run(PressedPrism& scene, const Program& program, Scheme scheme = Scheme::IMPLICIT) {
  StepControlOptions control;
  control.dt_max = 0.1;
  control.steps_per_width = 0;
  StepperOptions options;
  options.scheme = scheme;
  Diagnosis<3> diagnosis;
  Stepper<3> stepper(*scene.contact, scene.body, diagnosis, StepControl(0, control), options);
  Workpiece<3>& workpiece = scene.body.workpiece();
  for (;;) {
    const Task task = stepper.next(scene.u, scene.R);
    if (task == Task::PROGRAM) program(scene.tool->prescription(), stepper.target());
    if (task == Task::FORCES) {
      if (workpiece.update(scene.u, stepper.dt(), stepper.iteration()).status != UpdateStatus::OK)
        stepper.refuse("the material could not follow");
      scene.R = workpiece.internal_force();
    }
    if (task == Task::TANGENT && !factorize_tangent(*scene.contact, workpiece, scene.u)) stepper.refuse("");
    if (task == Task::STOPPED) ADD_FAILURE() << stepper.reason();
    if (task == Task::FINISHED || task == Task::STOPPED) return task;
  }
}

/// Down by 0.1 from the touch at z = 1 in the first half, then along x and y.
void down_and_along(Prescription& p, double t) {
  p.move("z", 1 - 0.2 * std::min(t, 0.5));
  p.move("x", 0.1 * std::max(0., t - 0.5));
  p.move("y", 0.05 * std::max(0., t - 0.5));
}

NodeState state_of(const PressedPrism& scene, int i) {
  return scene.contact->accepted().contact.nodes[i].state;
}

} // namespace

TEST(ContactInSpace, ApproachTouchesTheFlatTop) {
  PressedPrism scene(0.3);
  EXPECT_NEAR(scene.contact->approach(0, "z", scene.u), 1, 1e-12);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(state_of(scene, i), NodeState::STICKING);
}

TEST(ContactInSpace, ApproachOfASurfaceThatFacesAway) {
  PressedPrism scene(0);
  expect_invalid([&] { scene.contact->approach(0, "x", scene.u); },
                 "(the normal of its surface points to the body: turn one that faces away)");
}

// Sticking nodes go where the plane goes: the top's displacement is the tool's, and its forces are their reactions.
TEST(ContactInSpace, StickingNodesGoWithThePlane) {
  PressedPrism scene(50);
  scene.contact->approach(0, "z", scene.u);
  ASSERT_EQ(run(scene, down_and_along), Task::FINISHED);
  Vector<3> sum = Vector<3>::Zero();
  for (int a = 3; a < 6; ++a) {
    EXPECT_LE((scene.u.segment<3>(3 * a) - Vector<3>(0.05, 0.025, -0.1)).norm(), 1e-10) << a;
    sum += scene.R.segment<3>(3 * a);
  }
  EXPECT_LE((scene.tool->generalized_force() - sum).norm(), 1e-12);
  EXPECT_LE(sum[2], -0.05);
  const Eigen::VectorXd areas = tributary_areas(scene.contact->setup().model(), scene.contact->setup().body(),
                                                scene.mesh.facets, scene.u);
  EXPECT_NEAR(areas.sum(), 0.5, 1e-12);
}

// Without friction the top slides: no force along the plane, and pressing by the force found gives the depth back.
TEST(ContactInSpace, FrictionlessPlaneAndDuality) {
  PressedPrism moved(0), loaded(0);
  for (PressedPrism* scene : {&moved, &loaded}) scene->contact->approach(0, "z", scene->u);
  const Program down = [](Prescription& p, double t) {
    p.move("x", 0);
    p.move("y", 0);
    p.move("z", 1 - 0.1 * t);
  };
  ASSERT_EQ(run(moved, down), Task::FINISHED);
  const Eigen::VectorXd Q = moved.tool->generalized_force();
  EXPECT_LE(Q.head<2>().norm(), 1e-10);
  EXPECT_LE(Q[2], -0.01);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(state_of(moved, i), NodeState::SLIDING);
  const Program pressed = [&](Prescription& p, double t) {
    p.move("x", 0);
    p.move("y", 0);
    p.force("z", Q[2] * t);
  };
  ASSERT_EQ(run(loaded, pressed), Task::FINISHED);
  EXPECT_NEAR(loaded.tool->q()[2], 0.9, 1e-9);
  expect_close(loaded.u, moved.u, 0.1, 1e-8, "displacement");
}

// Drawn beyond what friction bears, nodes slide with |T| = mu N against their slip in the plane's two directions.
TEST(ContactInSpace, SlidingNodesLieOnTheCone) {
  PressedPrism scene(0.2);
  scene.contact->approach(0, "z", scene.u);
  ASSERT_EQ(run(scene,
                [](Prescription& p, double t) {
                  p.move("z", 1 - 0.2 * std::min(t, 0.5));
                  p.move("x", 0.6 * std::max(0., t - 0.5));
                  p.move("y", 0.3 * std::max(0., t - 0.5));
                }),
            Task::FINISHED);
  int sliding = 0;
  for (int i = 0; i < 3; ++i) {
    if (state_of(scene, i) != NodeState::SLIDING) continue;
    ++sliding;
    const Vector<3> F = scene.R.segment<3>(3 * scene.contact->setup().model().candidates[i]);
    EXPECT_NEAR(F.head<2>().norm(), 0.2 * -F[2], 1e-8);
    EXPECT_GE(F[0], 0) << "drawn along";
  }
  EXPECT_GE(sliding, 1);
}

// A plane that has pressed is turned about z and then tilted a little: its spins add up, the reference has turned along, and
// a state that is put back has its own.
TEST(ContactInSpace, TheReferenceOfSpinsIsPartOfTheState) {
  PressedPrism scene(50, std::make_shared<CartesianInSpace>());
  const auto& coordinates = scene.tool->tool().coordinates();
  scene.contact->approach(0, "z", scene.u);
  const auto start = scene.contact->state();
  const Program turn = [](Prescription& p, double t) {
    for (const char* name : {"x", "y", "spiny"}) p.move(name, 0);
    p.move("z", 1 - 0.2 * std::min(t, 0.5));
    p.move("spinz", 0.1 * std::min(1., 2 * t));
    p.move("spinx", 0.02 * std::max(0., 2 * t - 1));
  };
  ASSERT_EQ(run(scene, turn), Task::FINISHED);
  const Pose<3> end = coordinates.pose(scene.tool->q());
  const Tensor<3> expected =
      (Eigen::AngleAxisd(0.02, Vector<3>::UnitX()) * Eigen::AngleAxisd(0.1, Vector<3>::UnitZ()))
          .toRotationMatrix();
  expect_close(end.R, expected, 1, 3e-5, "R"); // one step turns about both axes
  const Tensor<3> at_once = CartesianInSpace().pose(scene.tool->q()).R;
  EXPECT_GT((end.R - at_once).norm(), 1e-3) << "not the turn about the sum of both";
  EXPECT_GT(std::abs(scene.tool->generalized_force()[5]), 1e-3) << "the moment that turns the top";
  const auto turned = scene.contact->state();
  scene.contact->set_state(start);
  expect_close(coordinates.pose(scene.tool->q()).R, Tensor<3>::Identity(), 1, 0, "R at the start");
  scene.contact->set_state(turned);
  expect_close(coordinates.pose(scene.tool->q()).R, end.R, 1, 0, "R put back");
}

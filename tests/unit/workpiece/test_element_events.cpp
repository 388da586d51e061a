#include "unit/material/j2/point_walk.hpp"
#include "unit/workpiece/patch.hpp"
#include "workpiece/element_events.hpp"
#include "workpiece/point_fields.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// One triangle whose deformation gradient is given from step to step.
struct Element {
  Workpiece<2> body;
  explicit Element(StressUpdate update = StressUpdate::SUBSTEPPED, int nodes = 3)
      : body(mesh(nodes), j2_law<2>(example_material()), options(update)) {}

  static Discretization<2> mesh(int nodes) {
    if (nodes == 3) return triangles(3, {0, 0, 2, 0, 0, 1}, {0, 1, 2});
    return triangles(6, {0, 0, 2, 0, 0, 1, 1, 0.5, 0, 0.5, 1, 0}, {0, 1, 2, 3, 4, 5});
  }
  static UpdateOptions options(StressUpdate update) {
    UpdateOptions options;
    options.update = update;
    return options;
  }
  void step_to(const Tensor<2>& F, double dt = 1) {
    ASSERT_EQ(body.update(homogeneous(body.discretization(), F), dt, 0).status, UpdateStatus::OK);
  }
  std::vector<ElementEvent<2>> events(double overshoot = 0) const {
    return element_events<2>(body, overshoot);
  }
};

Tensor<2> stretch(double e) { return tensor(1 + e, 0, 0, 1); }
/// Midpoint strain of the step from stretch a to stretch b.
double strain(double a, double b) { return (b - a) / (1 + (a + b) / 2); }
/// Strain that takes a uniaxially strained point from rest to yield: q = 2G |e|.
double yield_strain(double yield_stress = 1.93e8) {
  return yield_stress / (2 * example_material().elastic.G);
}

} // namespace

TEST(ElementEvents, YieldFractionOfAStretchIsExact) {
  const double y = yield_strain();
  for (double e : {1.01 * y, 2 * y, 10 * y, 0.3, -0.05}) {
    Element element;
    element.step_to(stretch(e));
    const auto events = element.events();
    ASSERT_EQ(events.size(), 1u) << "stretch " << e;
    EXPECT_EQ(events[0].change, PointChange::YIELD);
    EXPECT_EQ(events[0].point, 0);
    // f e/(1 + f e/2) = +-y
    const double sign = e > 0 ? 1 : -1, expected = sign * y / (e * (1 - sign * y / 2));
    EXPECT_NEAR(events[0].fraction, expected, 1e-10 * expected) << "stretch " << e;
  }
}

TEST(ElementEvents, AStepCutAtTheYieldEventEndsOnTheSurface) { // stressed, turned, sheared
  for (const StressUpdate update : {StressUpdate::SUBSTEPPED, StressUpdate::FORWARD_EULER}) {
    for (double size : {0.004, 0.02, 0.1}) {
      Element element(update);
      element.step_to(tensor(0.9995, 0.001, 0, 1.0005));
      element.body.accept();
      const Eigen::VectorXd start = element.body.state().displacement;
      element.step_to(tensor(1 + size, size, -2 * size, 1 - size));
      const auto events = element.events();
      ASSERT_EQ(events.size(), 1u);
      const Eigen::VectorXd end = element.body.state().displacement;
      element.body.revert();
      element.body.update(start + events[0].fraction * (end - start), events[0].fraction, 0);
      EXPECT_NEAR(yield_distance(element.body, 0), 0, 1e-12) << "size " << size;
    }
  }
}

TEST(ElementEvents, OvershootBringsThePointsThatWouldYieldSoonAfterTheEnd) {
  const double y = yield_strain();
  Element element;
  element.step_to(stretch(y / (1 - y / 2) / (1 + 5e-4))); // fraction 1 + 5e-4
  EXPECT_TRUE(element.events().empty());
  EXPECT_TRUE(element.events(4e-4).empty());
  ASSERT_EQ(element.events(6e-4).size(), 1u);
  EXPECT_EQ(element.events(6e-4)[0].fraction, 1);
}

TEST(ElementEvents, NoneWhileElasticNorWhileFlowGoesOn) {
  const double y = yield_strain();
  Element element;
  EXPECT_TRUE(element.events().empty()); // no step yet
  element.step_to(stretch(0.5 * y));
  EXPECT_TRUE(element.events().empty());
  element.body.accept();
  element.step_to(stretch(3 * y));
  element.body.accept();
  EXPECT_TRUE(element.events().empty()); // no increment
  element.step_to(stretch(5 * y));
  EXPECT_TRUE(element.events().empty());
}

TEST(ElementEvents, UnloadingWhereTheLoadingRateChangesSign) {
  const double y = yield_strain();
  struct Case {
    double dt_old, dt, back;
  };
  for (const Case c : {Case{1, 1, 0.2}, Case{1, 3, 0.9}, Case{0.5, 2, 0.3}, Case{1, 1, 1.9}}) {
    Element element;
    element.step_to(stretch(4 * y), c.dt_old);
    element.body.accept();
    element.step_to(stretch((4 - c.back) * y), c.dt);
    const auto events = element.events();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].change, PointChange::UNLOADING);
    const double before = strain(0, 4 * y) / c.dt_old, now = strain(4 * y, (4 - c.back) * y) / c.dt;
    const double after_middle = 0.5 * (c.dt_old + c.dt) * before / (before - now);
    EXPECT_NEAR(events[0].fraction, std::max(0., (after_middle - 0.5 * c.dt_old) / c.dt), 1e-9)
        << "back " << c.back;
  }
}

TEST(ElementEvents, UnloadingInTheLastStepIsAtOnce) { // equal times, faster back than forth
  const double y = yield_strain();
  Element element;
  element.step_to(stretch(1.2 * y));
  element.body.accept();
  element.step_to(stretch(-0.3 * y));
  ASSERT_EQ(element.events().size(), 1u);
  EXPECT_EQ(element.events()[0].fraction, 0);
}

TEST(ElementEvents, UnloadsAndYieldsAgainInOneStep) {
  const double y = yield_strain();
  Element element;
  element.step_to(stretch(1.5 * y));
  element.body.accept();
  const double a = 1.5 * y, b = -3 * y;
  const double range =
      2 * yield_strain(example_material().yield_stress(plastic_strain_eq_at(element.body.state(), 0)).value);
  element.step_to(stretch(b));
  const auto events = element.events();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].change, PointChange::UNLOADING);
  EXPECT_EQ(events[1].change, PointChange::YIELD);
  // f (b - a)/(1 + a + f (b - a)/2) = -range
  const double expected = range * (1 + a) / ((a - b) * (1 + range / 2));
  EXPECT_NEAR(events[1].fraction, expected, 1e-10);
}

TEST(ElementEvents, EarliestTakesAllWithinTheTolerance) {
  Workpiece<2> body(patch(6, 1), j2_law<2>(example_material()));
  body.update(bent(body.discretization(), 1, 0.01), 1, 0);
  const auto events = element_events<2>(body, 0);
  ASSERT_GT(events.size(), 5u);
  for (std::size_t k = 1; k < events.size(); ++k) EXPECT_LE(events[k - 1].fraction, events[k].fraction);
  const double gap = events[1].fraction - events[0].fraction;
  ASSERT_GT(gap, 0);
  EXPECT_EQ(earliest(events, 0.9 * gap).size(), 1u);
  EXPECT_EQ(earliest(events, 1.0001 * gap).size(), 2u);
  EXPECT_EQ(earliest(events, 1).size(), events.size());
  EXPECT_TRUE(earliest<2>({}, 1).empty());
}

TEST(ElementEvents, PointsThatWereSwitchedHaveNoSecondEvent) {
  const double y = yield_strain();
  Element element(StressUpdate::FORWARD_EULER);
  element.step_to(stretch((1 - 1e-4) * y)); // inside by what a batch may take
  element.body.accept();
  accept_events<2>({{1, PointChange::YIELD, 0, Vector<2>::Zero()}}, element.body);
  EXPECT_TRUE(element.body.state().plastic[0] && element.body.state_old().plastic[0]);
  element.step_to(stretch(1.5 * y));
  EXPECT_TRUE(element.events().empty());
  EXPECT_GT(plastic_strain_eq_at(element.body.state(), 0), 0); // forward Euler flows from the event on
  element.body.revert();
  accept_events<2>({{0, PointChange::UNLOADING, 0, Vector<2>::Zero()}}, element.body);
  element.step_to(stretch(1.5 * y));
  ASSERT_EQ(element.events().size(), 1u);
  EXPECT_EQ(element.events()[0].change, PointChange::YIELD);
}

TEST(ElementEvents, OutsideTheSurfaceOfForwardEuler) {
  const double y = yield_strain();
  Element element(StressUpdate::FORWARD_EULER);
  element.step_to(stretch(2 * y)); // elastic to the end: 100 % outside
  element.body.accept();
  element.step_to(stretch(2.5 * y));
  ASSERT_EQ(element.events().size(), 1u);
  EXPECT_EQ(element.events()[0].fraction, 0); // loads at once
  element.body.revert();
  element.step_to(stretch(1.5 * y)); // comes back: nothing happens
  EXPECT_TRUE(element.events().empty());
}

TEST(ElementEvents, Place) {
  for (int nodes : {3, 6}) {
    Element element(StressUpdate::SUBSTEPPED, nodes);
    const Tensor<2> F = tensor(1.05, 0.02, -0.01, 0.98);
    element.step_to(F);
    const auto events = element.events();
    ASSERT_EQ(static_cast<int>(events.size()), nodes / 2);
    for (const auto& event : events) {
      const Vector<2> X(element.body.discretization().point[2 * event.point],
                        element.body.discretization().point[2 * event.point + 1]);
      const Tensor<2> moved = Tensor<2>::Identity() + event.fraction * (F - Tensor<2>::Identity());
      EXPECT_NEAR((event.x - moved * X).norm(), 0, 1e-14);
    }
  }
}

TEST(ElementEvents, SameInOtherUnits) {
  std::vector<ElementEvent<2>> found[2];
  for (int mm : {0, 1}) {
    const double side = mm ? 1000 : 1;
    Workpiece<2> body(patch(3, side),
                      j2_law<2>(mm ? J2Parameters::from_shear(2.7e4, 0.32, 193, 962) : example_material()));
    body.update(bent(body.discretization(), side, 0.01), 1, 0);
    found[mm] = element_events<2>(body, 0);
  }
  ASSERT_EQ(found[0].size(), found[1].size());
  for (std::size_t k = 0; k < found[0].size(); ++k) {
    EXPECT_EQ(found[0][k].point, found[1][k].point);
    EXPECT_NEAR(found[0][k].fraction, found[1][k].fraction, 1e-12);
    EXPECT_NEAR((1000 * found[0][k].x - found[1][k].x).norm(), 0, 1e-9);
  }
}

TEST(ElementEvents, Errors) {
  Element element;
  EXPECT_THROW(element_events<2>(element.body, -1), std::invalid_argument);
  EXPECT_THROW(earliest<2>({}, -1e-3), std::invalid_argument);
  EXPECT_THROW(element.body.set_plastic(1, true), std::invalid_argument);
  EXPECT_THROW(element.body.set_plastic(-1, true), std::invalid_argument);
}

TEST(ElementEvents, NoiseNearTheSurfaceIsNoEvent) {
  const double y = yield_strain(), noise = 1e-4;
  Element element;
  const auto changes = [&](double tolerated) { return element_events<2>(element.body, 0, tolerated).size(); };
  element.step_to(stretch(2 * y));
  element.body.accept();
  element.step_to(stretch(2 * y * (1 - 1e-5))); // shaken inwards
  EXPECT_EQ(changes(0), 1u);
  EXPECT_EQ(changes(noise), 0u);
  EXPECT_FALSE(element.body.state().plastic[0]);
  keep_plastic(noise, element.body); // on the surface all the same
  EXPECT_TRUE(element.body.state().plastic[0]);
  element.body.accept();
  element.step_to(stretch(2 * y * (1 - 1e-2))); // unloads: q falls by 2 %
  EXPECT_EQ(changes(noise), 1u);
  keep_plastic(noise, element.body);
  EXPECT_FALSE(element.body.state().plastic[0]);

  Element other; // elastic to just below the surface
  other.step_to(stretch(y * (1 - 1e-5) / (1 - y / 2)));
  other.body.accept();
  other.step_to(stretch(y * (1 + 1e-5) / (1 - y / 2)));
  EXPECT_EQ(element_events<2>(other.body, 0, noise).size(), 0u);
  other.step_to(stretch(y * (1 + 1e-3) / (1 - y / 2)));
  ASSERT_EQ(element_events<2>(other.body, 0, noise).size(), 1u);
  EXPECT_EQ(element_events<2>(other.body, 0, noise)[0].fraction, 0); // it is on the surface but for the noise
  EXPECT_THROW(element_events<2>(other.body, 0, -noise), std::invalid_argument);
  EXPECT_THROW(keep_plastic(-noise, other.body), std::invalid_argument);
}

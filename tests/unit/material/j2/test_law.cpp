// J2 through the interface that the workpiece sees, with linear hardening and with a law that needs local solves.
#include "unit/material/j2/point_walk.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// sigma_y = sigma_0 + Q (1 - exp(-b ep)).
class Saturating final : public HardeningLaw {
  YieldStress evaluate(double plastic_strain_eq) const override {
    const double rest = std::exp(-30 * plastic_strain_eq);
    return {1.93e8 + 3e8 * (1 - rest), 3e8 * 30 * rest};
  }
};

J2Parameters saturating_material() { return {example_material().elastic, std::make_shared<Saturating>()}; }

/// A point with a law, led by the interface alone.
struct LawPoint {
  J2Law<2> law;
  UpdateOptions options;
  Point old;
  PointTrial trial;
  explicit LawPoint(J2Parameters material) : law(std::move(material)) {}

  static PointState<2> view(const Point& p) {
    return {Eigen::Map<const Gradient<2>>(p.F.data()), Eigen::Map<const Stress<2>>(p.stress.data()),
            &p.plastic_strain_eq, Eigen::Map<const Stress<2>>(p.strain_increment.data()), p.plastic};
  }
  PointStep<2> step(const AnyGradient& F, int iteration = 0) const {
    return {view(old), F, 0.8, iteration, options};
  }
  PointResult update(const AnyGradient& F, Point& end, int iteration = 0) {
    PointUpdate<2> now;
    now.internal = &end.plastic_strain_eq;
    const PointResult result = law.update(step(F, iteration), trial, now);
    if (result.status == UpdateStatus::OK)
      end = {F, now.stress, end.plastic_strain_eq, now.strain_increment, now.plastic};
    return result;
  }
  Point at(const AnyGradient& F, int iteration = 0) {
    Point end;
    EXPECT_EQ(update(F, end, iteration).status, UpdateStatus::OK);
    return end;
  }
  Gradient<2> piola(const AnyGradient& F, int iteration) {
    return first_piola(at(F, iteration).stress, inverse(F));
  }
};

const Gradient<2> START = gradient(tensor(1.01, 0.004, -0.002, 0.99), 1.002);
const Gradient<2> END = gradient(rotation(0.1) * tensor(1.03, 0.01, -0.02, 0.975), 1.004);

} // namespace

TEST(J2Law, EndsOnTheSurfaceOfAnyHardening) {
  for (const J2Parameters& material : {example_material(), saturating_material()})
    for (StressUpdate update : {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED}) {
      LawPoint point(material);
      point.options.update = update;
      for (const Gradient<2>& F : {START, END}) {
        point.old = point.at(F);
        EXPECT_TRUE(point.old.plastic);
        EXPECT_NEAR(point.law.yield_distance(point.old.stress, &point.old.plastic_strain_eq), 0, 1e-13);
      }
      EXPECT_GT(point.old.plastic_strain_eq, 0.02);
    }
}

TEST(J2Law, ConsistentTangentAgainstFiniteDifferences) {
  for (const J2Parameters& material : {example_material(), saturating_material()})
    for (StressUpdate update :
         {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED, StressUpdate::FORWARD_EULER}) {
      LawPoint point(material);
      point.options.update = update;
      point.old = point.at(START);
      const Point now = point.at(END);
      const int frozen = FREEZE_ITERATION;
      PiolaTangent<2> measured;
      for (int c = 0; c < 5; ++c)
        measured.col(c) = finite_difference(
            [&](double t) { return point.piola(END + t * Gradient<2>::Unit(c), frozen); }, 0, 1e-6);
      const PiolaTangent<2> A =
          point.law.tangent(TangentKind::CONSISTENT, point.step(END), point.trial, LawPoint::view(now));
      EXPECT_LE((A - measured).norm(), 1e-8 * measured.norm()) << "update " << static_cast<int>(update);
    }
}

TEST(J2Law, RateTangentIsTheLimitOfTheConsistentOne) { // of a law whose slope changes
  LawPoint point(saturating_material());
  point.options.update = StressUpdate::SINGLE;
  point.old = point.at(START);
  const PointState<2> start = LawPoint::view(point.old);
  const PiolaTangent<2> rate = point.law.tangent(TangentKind::RATE, point.step(START), {}, start);
  const Gradient<2> F = START + 1e-6 * (START - undeformed<2>());
  const Point now = point.at(F);
  ASSERT_TRUE(now.plastic);
  const PiolaTangent<2> near =
      point.law.tangent(TangentKind::CONSISTENT, point.step(F), point.trial, LawPoint::view(now));
  EXPECT_LE((near - rate).norm(), 1e-4 * rate.norm());
  const PiolaTangent<2> elastic = point.law.tangent(TangentKind::ELASTIC, point.step(START), {}, start);
  EXPECT_GT((elastic - rate).norm(), 0.1 * rate.norm());
}

TEST(J2Law, AFunctionOfItsArguments) { // the same from another object, after other calls
  LawPoint point(example_material()), other(example_material());
  point.old = point.at(START);
  point.at(gradient(tensor(1.2, 0, 0.1, 0.9)));
  point.trial = {};
  other.old = point.old;
  const Point a = point.at(END), b = other.at(END);
  EXPECT_EQ(a.stress, b.stress);
  EXPECT_EQ(a.plastic_strain_eq, b.plastic_strain_eq);
  EXPECT_EQ(point.trial.used, other.trial.used);
}

TEST(J2Law, SubstepsGrowThenFreeze) {
  LawPoint point(example_material());
  point.old = point.at(START);
  point.trial = {};
  const Gradient<2> near = START + 0.05 * (END - START);
  point.at(near, 0);
  const int few = point.trial.used;
  EXPECT_GE(few, point.options.min_substeps);
  point.at(END, FREEZE_ITERATION);
  EXPECT_EQ(point.trial.used, few);
  point.at(END, 1);
  const int many = point.trial.used;
  EXPECT_GT(many, few);
  point.at(near, 2);
  EXPECT_EQ(point.trial.used, many);
}

TEST(J2Law, LoadsAndYieldDistance) {
  const J2Law<2> law(example_material());
  Point at;
  at.plastic_strain_eq = 0.1;
  at.stress = on_surface(example_material(), {1, -0.2, -0.8, 0.9}, 0.1);
  const Stress<2> outward = deviator<2>(at.stress);
  at.stress.head<3>().array() += 3e8; // pressure does not matter
  EXPECT_NEAR(law.yield_distance(at.stress, &at.plastic_strain_eq), 0, 1e-14);
  EXPECT_NEAR(law.yield_distance(Stress<2>(1.5 * at.stress), &at.plastic_strain_eq), 0.5, 1e-14);
  EXPECT_TRUE(law.loads(LawPoint::view(at), outward));
  EXPECT_FALSE(law.loads(LawPoint::view(at), -outward));
  at.stress *= 0.9;
  EXPECT_FALSE(law.loads(LawPoint::view(at), outward));
  at.plastic = true; // put on the surface by an event
  EXPECT_TRUE(law.loads(LawPoint::view(at), outward));
}

TEST(J2Law, AStepThroughASingularMiddleIsAStatus) {
  LawPoint point(example_material());
  Point end;
  const PointResult result = point.update(tensor(-0.5, 0, 0, -3), end); // det F = 1.5, det F_mid = -0.25
  EXPECT_EQ(result.status, UpdateStatus::INVERTED_ELEMENT);
  EXPECT_NEAR(result.value, -0.25, 1e-15);
  EXPECT_EQ(point.law.yield_fraction(point.step(tensor(-0.5, 0, 0, -3)), 1, 0), NEVER);
  EXPECT_EQ(point.law.loading(point.step(tensor(-0.5, 0, 0, -3))).now, 0);
  point.update(tensor(1e200, 0, 0, 1e200), end);
  EXPECT_EQ(point.update(tensor(1e200, 0, 0, 1e200), end).status, UpdateStatus::NOT_FINITE);
}

TEST(J2Law, Errors) {
  expect_invalid(
      [] {
        J2Law<2>(J2Parameters{example_material().elastic, nullptr});
      },
      "J2Law: there is no hardening law");
  J2Parameters soft = example_material();
  soft.elastic.G = 0;
  expect_invalid([&] { J2Law<2>{soft}; }, "J2Law: G = 0, expected finite > 0");
  expect_invalid([] { J2Parameters::from_shear(1, 0.3, 0, 1); },
                 "J2Parameters::from_shear: sigY = 0, expected finite > 0");
  expect_invalid([] { J2Parameters::from_young(0, 0.3, 1, 1); },
                 "J2Parameters::from_young: E = 0, expected finite > 0");
}

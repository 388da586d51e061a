// J2 in space, every hardening, back stress and rate: tangents against finite differences, the plane in any plane of
// space, rigid rotations of a point with stress and back stress.
#include "unit/material/in_space.hpp"
#include "unit/material/j2/law_point.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

struct Variant {
  std::string name;
  LawInput input;
};

std::vector<Variant> variants() {
  std::vector<Variant> list;
  for (const char* rate : {"jaumann", "greennaghdi", "logarithmic", "small"}) {
    const auto add = [&](const char* name, LawNumbers numbers, const char* hardening = "",
                         const char* backstress = "none") {
      LawInput input{with_example_elasticity(std::move(numbers))};
      if (rate == std::string("small"))
        input.small_strain = true;
      else
        input.rate = rate;
      input.hardening = hardening;
      input.backstress = backstress;
      if (name == std::string("table")) {
        input.plastic_strain = {0, 0.004, 0.2};
        input.yield_stress = {193e6, 240e6, 600e6};
      }
      list.push_back({std::string(rate) + ", " + name, input});
    };
    add("perfect", {{"sigY", 1.93e8}}, "perfect");
    add("linear", {{"sigY", 1.93e8}, {"H", 9.62e8}});
    add("formula", {}, "193e6*(1 + ep/0.002)^0.2");
    add("table", {});
    add("Prager", {{"sigY", 1.93e8}, {"H", 9.62e8}, {"C", 3e9}}, "", "prager");
    add("formula, Armstrong-Frederick", {{"C", 8e9}, {"gamma", 60}}, "193e6*(1 + ep/0.002)^0.2",
        "armstrongfrederick");
  }
  return list;
}

using SpacePoint = LawPointOf<3>;
const StressUpdate UPDATES[] = {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED, StressUpdate::FORWARD_EULER};

Gradient<3> start() {
  Gradient<3> F = gradient_in_space(0.7);
  F[0] += 0.3; // far from round, so that the rates differ
  return F;
}
/// Two steps that flow, in different directions, to start().
SpacePoint at_start(const Variant& variant, StressUpdate update) {
  SpacePoint point(variant.input, update);
  const Gradient<3> other = (Gradient<3>() << 0.2, -0.6, 0.4, -0.5, -0.1, 0.3, 0.5, -0.2, -0.1).finished();
  const Gradient<3> before = start() - 0.008 * (gradient_in_space(1) - undeformed<3>());
  point.old.F = before + 0.015 * other;
  point.advance(before);
  point.advance(start());
  return point;
}

} // namespace

TEST(LawInSpace, ConsistentTangentAgainstFiniteDifferences) {
  const Gradient<3> on = (Gradient<3>() << 0.9, -0.7, 0.3, 0.3, -0.6, 0.5, -0.4, 0.2, -0.2).finished();
  for (const Variant& variant : variants())
    for (StressUpdate update : UPDATES)
      for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END}) {
        SCOPED_TRACE(variant.name + ", update " + std::to_string(static_cast<int>(update)));
        SpacePoint point = at_start(variant, update);
        point.options.strain_frame = frame;
        const bool euler = update == StressUpdate::FORWARD_EULER; // loads where it goes on
        const Gradient<3> way = euler ? Gradient<3>(gradient_in_space(1) - undeformed<3>()) : on;
        Gradient<3> F = start() + 0.015 * way;
        if (!variant.input.small_strain) F = turned(turn_about({1, -2, 0.5}, 0.1), F);
        EXPECT_TRUE(point.at(F).plastic);
        EXPECT_LE(point.tangent_error(F), 1e-7);
      }
}

TEST(LawInSpace, RateTangentIsTheLimitOfTheConsistentOne) {
  for (const Variant& variant : variants()) {
    SCOPED_TRACE(variant.name);
    SpacePoint point = at_start(variant, StressUpdate::SINGLE);
    const PiolaTangent<3> rate =
        point.law->tangent(TangentKind::RATE, point.step(start()), {}, point.old.view());
    double before = 0;
    for (double size : {4e-6, 2e-6}) {
      const Gradient<3> F = start() + size * (gradient_in_space(1) - undeformed<3>());
      const auto now = point.at(F);
      ASSERT_TRUE(now.plastic);
      const PiolaTangent<3> A =
          point.law->tangent(TangentKind::CONSISTENT, point.step(F), point.trial, now.view());
      const double error = (A - rate).norm() / rate.norm();
      EXPECT_LE(error, 1e-3);
      if (before > 0 && before > 1e-9) {
        EXPECT_NEAR(before / error, 2, 0.1) << error;
      }
      before = error;
    }
    if (variant.input.rate == "jaumann") {
      EXPECT_LE((rate - rate.transpose()).norm(), 1e-13 * rate.norm());
    }
  }
}

TEST(LawInSpace, InAPlaneOfSpaceItIsThatOfThePlane) {
  const Tensor<3> planes[] = {Tensor<3>::Identity(), turn_about({1, 0, 0}, M_PI / 2),
                              turn_about({1, 2, -1}, 1.1), turn_about({-0.3, 0.2, 0.9}, 2.7)};
  double worst = 0;
  for (const Variant& variant : variants())
    for (StressUpdate update : UPDATES)
      for (const Tensor<3>& Q : planes) {
        SCOPED_TRACE(variant.name + ", update " + std::to_string(static_cast<int>(update)));
        AnyLawPoint flat(variant.input, update);
        SpacePoint point(variant.input, update);
        for (int k = 1; k <= 20; ++k) { // simple shear to 0.4
          const Gradient<2> F = gradient(tensor(1, 0.02 * k, 0, 1));
          flat.advance(F);
          point.advance(in_space(F, Q));
        }
        const auto error = [&](const Stress<2>& plane, const Stress<3>& space) {
          return (space - in_space(plane, Q)).norm() / flat.old.stress.norm();
        };
        worst = std::max(worst, error(flat.old.stress, point.old.stress));
        if (variant.input.backstress != "none")
          worst = std::max(worst, error(flat.old.backstress(),
                                        Eigen::Map<const Stress<3>>(point.old.internal.data() + 1)));
        EXPECT_GT(flat.old.plastic_strain_eq(), 0.2);
        EXPECT_NEAR(point.old.internal[0], flat.old.plastic_strain_eq(), 1e-12);
      }
  EXPECT_LE(worst, 1e-12);
  RecordProperty("largest_error", std::to_string(worst * 1e15) + "e-15");
}

TEST(LawInSpace, ARigidRotationAboutAnyAxisTurnsTheWholeState) {
  for (const Variant& variant : variants()) {
    if (variant.input.small_strain) continue;
    for (StressUpdate update : UPDATES)
      for (const Vector<3>& axis : {Vector<3>(0, 0, 1), Vector<3>(1, 2, -1), Vector<3>(-1, 0.2, 0.1)}) {
        SCOPED_TRACE(variant.name);
        SpacePoint point = at_start(variant, update);
        point.options.path_limit = 0; // a curved path goes on flowing
        point.old.plastic = false;
        const auto before = point.old;
        const Tensor<3> turn = turn_about(axis, 0.9);
        for (int k = 0; k < 3; ++k) point.advance(turned(turn, point.old.F));
        const Tensor<3> R = turn_about(axis, 2.7);
        EXPECT_LE((point.old.stress - rotated(before.stress, R)).norm(), 1e-11 * before.stress.norm());
        EXPECT_NEAR(point.old.internal[0], before.internal[0], 1e-12);
        if (variant.input.backstress == "none") continue;
        const Stress<3> X = Eigen::Map<const Stress<3>>(point.old.internal.data() + 1),
                        X_before = Eigen::Map<const Stress<3>>(before.internal.data() + 1);
        EXPECT_LE((X - rotated(X_before, R)).norm(), 1e-11 * X_before.norm());
      }
  }
}

TEST(LawInSpace, YieldFractionAndLoadingAreThoseOfThePlane) {
  const Tensor<3> Q = turn_about({1, 2, -1}, 1.1);
  for (const Variant& variant : variants()) {
    AnyLawPoint flat(variant.input);
    SpacePoint point(variant.input);
    const Gradient<2> F = gradient(tensor(1.01, 0.004, 0, 0.99));
    const double expected = flat.law->yield_fraction(flat.step(F), 1, 0);
    EXPECT_GT(expected, 0.1) << variant.name;
    EXPECT_NEAR(point.law->yield_fraction(point.step(in_space(F, Q)), 1, 0), expected, 1e-12);
    flat.advance(F);
    point.advance(in_space(F, Q));
    const Gradient<2> back = gradient(tensor(1.008, 0.003, 0, 0.99));
    const PointLoading a = flat.law->loading(flat.step(back)),
                       b = point.law->loading(point.step(in_space(back, Q)));
    EXPECT_LT(a.now, 0);
    EXPECT_NEAR(b.now / a.now, 1, 1e-11);
    EXPECT_NEAR(b.elastic_distance, a.elastic_distance, 1e-11);
  }
}

// Every corotational rate with every kind of hardening: consistent tangent, rate tangent, objectivity.
#include "unit/material/j2/law_point.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

struct Variant {
  std::string name;
  LawInput input;
  bool plastic = true;
};

std::vector<Variant> variants() {
  std::vector<Variant> list;
  for (const char* rate : {"jaumann", "greennaghdi", "logarithmic"}) {
    const auto add = [&](const char* name, LawNumbers numbers, const auto& change) {
      LawInput input{with_example_elasticity(std::move(numbers))};
      input.rate = rate;
      change(input);
      list.push_back({std::string(rate) + ", " + name, input,
                      input.numbers.count("sigY") == 0 || input.numbers["sigY"] < 1e12});
    };
    const auto as_is = [](LawInput&) {};
    const auto prager = [](LawInput& input) { input.backstress = "prager"; };
    const auto frederick = [](LawInput& input) { input.backstress = "armstrongfrederick"; };
    add("elastic", {{"sigY", 1e13}, {"H", 0}}, as_is);
    add("isotropic", {{"sigY", 1.93e8}, {"H", 9.62e8}}, as_is);
    add("Prager", {{"sigY", 1.93e8}, {"H", 9.62e8}, {"C", 3e9}}, prager);
    add("Armstrong-Frederick", {{"sigY", 1.93e8}, {"H", 9.62e8}, {"C", 8e9}, {"gamma", 60}}, frederick);
    add("formula", {}, [](LawInput& input) { input.hardening = "193e6*(1 + ep/0.002)^0.2"; });
    add("table", {}, [](LawInput& input) {
      input.plastic_strain = {0, 0.004, 0.2};
      input.yield_stress = {193e6, 240e6, 600e6};
    });
    add("formula, Armstrong-Frederick", {{"C", 8e9}, {"gamma", 60}}, [](LawInput& input) {
      input.hardening = "193e6*(1 + ep/0.002)^0.2";
      input.backstress = "armstrongfrederick";
    });
    add("softening, Prager", {{"sigY", 1.93e8}, {"H", -9e8}, {"C", 3e9}}, [](LawInput& input) {
      input.softening = true;
      input.backstress = "prager";
    });
  }
  return list;
}

// A body that is already far from round, so that the rates differ
const Gradient<2> START = gradient(tensor(1.5, 0.5, -0.1, 0.8), 1.002);
Gradient<2> before(double size) { return START - size * gradient(tensor(0.6, 0.2, 0.5, -0.4), 0.2); }
/// From there to before(0.008) in another direction than from there on: the back stress is not along the stress.
Gradient<2> first() { return before(0.008) + 0.015 * gradient(tensor(0.2, -0.6, -0.5, -0.1), -0.1); }
Gradient<2> behind(double size, double angle) {
  return gradient(rotation(angle) *
                      in_plane(Gradient<2>(START + size * gradient(tensor(0.9, -0.7, 0.3, -0.6), 0.1))),
                  1.002 + 0.1 * size);
}

/// Stress and back stress of two steps that flow, at START.
AnyLawPoint at_start(const Variant& variant, StressUpdate update) {
  AnyLawPoint point(variant.input, update);
  point.old.F = first();
  point.advance(before(0.008));
  point.advance(START);
  return point;
}

} // namespace

TEST(LawVariants, ConsistentTangentAgainstFiniteDifferences) {
  double worst = 0;
  for (const Variant& variant : variants())
    for (StressUpdate update : {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED, StressUpdate::FORWARD_EULER})
      for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END}) {
        SCOPED_TRACE(variant.name + ", update " + std::to_string(static_cast<int>(update)));
        AnyLawPoint point = at_start(variant, update);
        point.options.strain_frame = frame;
        // forward Euler is outside after the steps before: it loads where they go on
        const Gradient<2> on = gradient(rotation(0.1) * in_plane(before(-0.01)), before(-0.01)[ZZ]);
        const Gradient<2> F = update == StressUpdate::FORWARD_EULER ? on : behind(0.015, 0.1);
        EXPECT_EQ(point.at(F).plastic, variant.plastic);
        const double error = point.tangent_error(F);
        EXPECT_LE(error, 1e-7);
        worst = std::max(worst, error);
      }
  RecordProperty("largest_error", std::to_string(worst * 1e9) + "e-9");
}

TEST(LawVariants, RateTangentIsTheLimitOfTheConsistentOne) {
  for (const Variant& variant : variants()) {
    SCOPED_TRACE(variant.name);
    AnyLawPoint point = at_start(variant, StressUpdate::SINGLE);
    const PiolaTangent<2> rate =
        point.law->tangent(TangentKind::RATE, point.step(START), {}, point.old.view());
    double before_error = 0;
    for (double size : {4e-6, 2e-6}) {
      const Gradient<2> F = START + size * gradient(tensor(0.6, 0.2, 0.5, -0.4), 0.2);
      const LawState now = point.at(F);
      ASSERT_EQ(now.plastic, variant.plastic);
      const PiolaTangent<2> A =
          point.law->tangent(TangentKind::CONSISTENT, point.step(F), point.trial, now.view());
      const double error = (A - rate).norm() / rate.norm();
      EXPECT_LE(error, 1e-3);
      if (before_error > 0) {
        EXPECT_NEAR(before_error / error, 2, 0.1) << error;
      }
      before_error = error;
    }
  }
}

TEST(LawVariants, ARigidRotationTurnsTheWholeState) {
  for (const Variant& variant : variants())
    for (StressUpdate update :
         {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED, StressUpdate::FORWARD_EULER}) {
      SCOPED_TRACE(variant.name);
      AnyLawPoint point = at_start(variant, update);
      point.options.path_limit = 0; // a curved path goes on flowing
      point.old.plastic = false;
      point.old.stress *= 0.9; // off the surface
      for (double angle : {0.7, -2.5}) {
        const Tensor<2> Q = rotation(angle);
        const LawState now = point.at(gradient(Q * in_plane(START), START[ZZ]));
        const double size = point.old.stress.norm();
        expect_close(now.stress, turned(point.old.stress, Q), size, 2e-11, "stress"); // of G eps
        EXPECT_NEAR(now.plastic_strain_eq(), point.old.plastic_strain_eq(), 1e-14);
        if (now.internal.size() > 1)
          expect_close(now.backstress(), turned(point.old.backstress(), Q), size, 1e-13, "back stress");
      }
    }
}

TEST(LawVariants,
     TheFrameOfTheObserverDoesNotMatter) { // the whole motion seen by an observer who is turned by Q
  const Tensor<2> Q = rotation(1.1);
  for (const Variant& variant : variants()) {
    SCOPED_TRACE(variant.name);
    AnyLawPoint point(variant.input, StressUpdate::SUBSTEPPED), seen = point;
    seen.old.F = gradient(Q * in_plane(first()), first()[ZZ]);
    point.old.F = first();
    for (const Gradient<2>& F : {before(0.008), START, behind(0.015, 0.1)}) {
      point.advance(F);
      seen.advance(gradient(Q * in_plane(F), F[ZZ]));
    }
    expect_close(seen.old.stress, turned(point.old.stress, Q), point.old.stress.norm(), 1e-11, "stress");
    EXPECT_NEAR(seen.old.plastic_strain_eq(), point.old.plastic_strain_eq(), 1e-13);
    if (point.old.internal.size() > 1)
      expect_close(seen.old.backstress(), turned(point.old.backstress(), Q), 1e8, 1e-10, "back stress");
  }
}

TEST(LawVariants, EndsOnTheSurface) {
  for (const Variant& variant : variants())
    for (StressUpdate update : {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED}) {
      if (!variant.plastic) continue;
      SCOPED_TRACE(variant.name);
      AnyLawPoint point = at_start(variant, update);
      point.advance(behind(0.015, 0.1));
      EXPECT_TRUE(point.old.plastic);
      EXPECT_NEAR(point.yield_distance(), 0, 1e-12);
      EXPECT_GT(point.old.plastic_strain_eq(), 0.02);
      if (point.old.internal.size() == 1) continue;
      const Stress<2> X = point.old.backstress();
      EXPECT_GT(equivalent<2>(X), 2e7);
      EXPECT_NEAR(mean<2>(X), 0, 1e-14 * X.norm()) << "deviatoric";
    }
}

TEST(LawVariants, YieldFractionCutsOnTheSurface) { // a step cut there, elastic, ends on the surface around X
  int cut = 0;
  for (const Variant& variant : variants()) {
    if (!variant.plastic) continue;
    SCOPED_TRACE(variant.name);
    AnyLawPoint point = at_start(variant, StressUpdate::SINGLE);
    const Gradient<2> back = before(0.002);
    point.options.path_limit = 0;
    point.advance(back); // unloads
    ASSERT_FALSE(point.old.plastic);
    ASSERT_LT(point.yield_distance(), -0.01);
    const Gradient<2> F = behind(0.02, 0.1);
    const double fraction = point.law->yield_fraction(point.step(F), 1, 0);
    ASSERT_GT(fraction, 0);
    ASSERT_LT(fraction, 1);
    const LawState end = point.at(back + fraction * (F - back));
    EXPECT_NEAR(point.law->yield_distance(end.stress, end.internal.data()), 0, 1e-12);
    EXPECT_GT(point.law->loading(point.step(F)).elastic_distance, 0.1);
    ++cut;
  }
  EXPECT_EQ(cut, 21);
}

TEST(LawVariants, SecondOrderWhereBodyAndStrainTurn) {
  // directions of the strain turn by a right angle in a body that spins and is far from round; substeps grow with the
  // steps, so that the error of the returns falls like that of the path and of the rotation
  const auto path = [](double t) {
    const double a = 0.03 * std::sin(2 * t), b = 0.03 * (1 - std::cos(2 * t));
    return gradient(rotation(1.5 * t) * tensor(1 + a, b, b, 1 - a) * tensor(1.6, 0.3, 0, 0.7));
  };
  for (const char* rate : {"jaumann", "greennaghdi", "logarithmic"}) {
    LawInput input{with_example_elasticity({{"C", 8e9}, {"gamma", 60}}), "193e6*(1 + ep/0.002)^0.2"};
    input.backstress = "armstrongfrederick";
    input.rate = rate;
    const auto end_of = [&](int n, int substeps) {
      AnyLawPoint point(input, StressUpdate::SUBSTEPPED);
      point.options.min_substeps = point.options.max_substeps = substeps;
      point.old.F = path(0);
      for (int k = 1; k <= n; ++k) {
        point.ratio = k > 1 ? 1 : 0;
        point.advance(path(static_cast<double>(k) / n));
      }
      return point.old;
    };
    const LawState exact = end_of(2000, 100);
    ASSERT_GT(exact.plastic_strain_eq(), 0.05);
    const auto errors = [&](int n) -> Eigen::Vector2d {
      const LawState end = end_of(n, 5 * n);
      return {(end.stress - exact.stress).norm() / exact.stress.norm(),
              (end.backstress() - exact.backstress()).norm() / exact.backstress().norm()};
    };
    const Eigen::Vector2d coarse = errors(20), fine = errors(40);
    for (int k : {0, 1}) EXPECT_NEAR(std::log2(coarse[k] / fine[k]), 2, 0.2) << rate << ", " << fine[k];
    EXPECT_LT(fine[0], 1e-3) << rate;
  }
}

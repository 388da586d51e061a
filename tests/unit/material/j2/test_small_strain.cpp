// strain="small": the geometrically linear form of the core's law.
#include "unit/material/j2/law_point.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

LawInput small(LawInput input) {
  input.small_strain = true;
  return input;
}
LawInput isotropic() { return {with_example_elasticity({{"sigY", 1.93e8}, {"H", 9.62e8}})}; }
LawInput with_backstress() {
  LawInput input{with_example_elasticity({{"sigY", 1.93e8}, {"H", 9.62e8}, {"C", 8e9}, {"gamma", 60}})};
  input.backstress = "armstrongfrederick";
  return input;
}
Gradient<2> strained(double size) {
  return undeformed<2>() + size * gradient(tensor(0.6, 0.9, -0.3, -0.4), 0.2);
}

} // namespace

TEST(SmallStrain, TangentIsTheDerivativeOfTheForce) {
  for (const LawInput& input : {isotropic(), with_backstress()})
    for (StressUpdate update : {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED}) {
      AnyLawPoint point(small(input), update);
      point.advance(strained(0.02));
      const Gradient<2> F = strained(0.05) + 0.01 * gradient(tensor(-0.2, 0.3, 0.5, 0.1), 0);
      ASSERT_TRUE(point.at(F).plastic);
      EXPECT_LE(point.tangent_error(F), 1e-7);
    }
}

TEST(SmallStrain, RateTangentIsTheLimitOfTheConsistentOne) {
  AnyLawPoint point(small(isotropic()));
  point.advance(strained(0.02));
  const PiolaTangent<2> rate =
      point.law->tangent(TangentKind::RATE, point.step(strained(0.02)), {}, point.old.view());
  const Gradient<2> F = strained(0.02 + 1e-6);
  const LawState now = point.at(F);
  ASSERT_TRUE(now.plastic);
  const PiolaTangent<2> A =
      point.law->tangent(TangentKind::CONSISTENT, point.step(F), point.trial, now.view());
  EXPECT_LE((A - rate).norm() / rate.norm(), 1e-3);
  EXPECT_LE((A - A.transpose()).norm(), 1e-12 * A.norm());
}

TEST(SmallStrain, HookeAtAnyGradient) {
  LawInput input{with_example_elasticity({{"sigY", 1e13}, {"H", 0}})};
  AnyLawPoint point(small(input));
  const double G = 2.7e10, nu = 0.32, lame = 2 * G * nu / (1 - 2 * nu);
  const Gradient<2> F = gradient(tensor(1.3, 0.7, -0.1, 0.8), 1.2);
  const Stress<2> stress = point.at(F).stress;
  const double trace = 0.3 - 0.2 + 0.2;
  const Stress<2> expected{lame * trace + 2 * G * 0.3, lame * trace - 2 * G * 0.2, lame * trace + 2 * G * 0.2,
                           G * 0.6};
  EXPECT_LE((stress - expected).norm(), 1e-12 * expected.norm());
  const Gradient<2> P = point.piola(F, 0); // symmetric, whatever turns
  EXPECT_EQ(P[1], P[2]);
  EXPECT_EQ(P[0], stress[0]);
}

TEST(SmallStrain, DiffersFromTheFiniteStepInFirstOrder) {
  double before = 0;
  for (double size : {4e-3, 2e-3}) {
    AnyLawPoint linear(small(isotropic())), finite(isotropic());
    const Gradient<2> P = finite.piola(strained(size), 0);
    const double error = (linear.piola(strained(size), 0) - P).norm() / P.norm();
    if (before > 0) {
      EXPECT_NEAR(before / error, 2, 0.1);
    }
    EXPECT_LE(error, 2 * size);
    before = error;
  }
}

TEST(SmallStrain, NothingTurnsIn) {
  LawInput input = small(isotropic());
  input.rate = "logarithmic";
  expect_invalid(
      [&] { make_law<2>(input, "here"); },
      "here: rate=\"logarithmic\" with strain=\"small\", in which nothing turns, expected one of them");
}

// Kinematic hardening and perfect plasticity against closed forms, in uniaxial stress.
#include "unit/material/j2/law_point.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const double G = 2.7e10, NU = 0.32, E = 2 * G * (1 + NU), SIGMA_Y = 1.93e8;

LawInput law_of(LawNumbers numbers, const std::string& hardening, const std::string& backstress) {
  LawInput input{with_example_elasticity(std::move(numbers)), hardening};
  input.backstress = backstress;
  return input;
}

/// One step of uniaxial stress along x: the stretches across are found so that yy and zz vanish.
/// @param factor by which F_xx grows; @return strain increment along x [-]
double pull(AnyLawPoint& point, double factor) {
  Gradient<2> F = point.old.F;
  F[0] *= factor;
  const auto across = [&](double stretch) {
    F[3] = F[ZZ] = point.old.F[3] * stretch;
    point.trial = {};
    return point.at(F).stress[1];
  };
  double a = 1, b = 1 / std::sqrt(factor), fa = across(a), fb = across(b);
  for (int k = 0; k < 100 && std::abs(fb) > 1e-13 * SIGMA_Y && fb != fa; ++k) {
    const double c = b - fb * (b - a) / (fb - fa);
    a = b, fa = fb;
    b = c, fb = across(b);
  }
  point.advance(F);
  EXPECT_NEAR(point.old.stress[1], 0, 1e-6 * SIGMA_Y);
  EXPECT_NEAR(point.old.stress[2], 0, 1e-6 * SIGMA_Y);
  return 2 * (factor - 1) / (factor + 1);
}

} // namespace

TEST(Backstress, PragerCycleIsBilinear) {
  // the yield surface keeps its size and moves: sigma = X + -sigY with E_t = E C/(E + C), exact in any number of steps
  const double C = 4e9, tangent = E * C / (E + C);
  for (StressUpdate update : {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED}) {
    AnyLawPoint point(law_of({{"sigY", SIGMA_Y}, {"C", C}}, "perfect", "prager"), update);
    point.ratio = 0;
    double strain = 0, plastic = 0, slid = 0; // along x: strain, plastic strain, its way
    for (double factor : {1.01, 1.02, 0.97, 0.99, 1.03, 0.96}) {
      const double increment = pull(point, factor);
      strain += increment;
      // one-dimensional return, in closed form
      const double trial = E * (strain - plastic) - C * plastic, way = std::abs(trial) - SIGMA_Y;
      if (way > 0) {
        plastic += std::copysign(way / (E + C), trial);
        slid += way / (E + C);
      }
      EXPECT_NEAR(point.old.stress[0], E * (strain - plastic), 2e-7 * SIGMA_Y);
      EXPECT_NEAR(point.old.plastic_strain_eq(), slid, 1e-9);
      EXPECT_NEAR(1.5 * point.old.backstress()[0], C * plastic, 2e-7 * SIGMA_Y) << "X_xx of uniaxial C eps_p";
    }
    EXPECT_GT(slid, 0.1);
  }
  AnyLawPoint point(law_of({{"sigY", SIGMA_Y}, {"C", C}}, "perfect", "prager")); // the branch's slope
  pull(point, 1.01);
  const double start = point.old.stress[0], increment = pull(point, 1.01);
  EXPECT_NEAR((point.old.stress[0] - start) / (tangent * increment), 1, 1e-8);
}

TEST(Backstress, BauschingerEffect) { // after pulling, yield in compression at X - sigY, not at -sigma
  AnyLawPoint point(law_of({{"sigY", SIGMA_Y}, {"C", 4e9}}, "perfect", "prager"));
  pull(point, 1.02);
  const double top = point.old.stress[0];
  pull(point, 1 - (2 * SIGMA_Y - 4e6) / E);
  EXPECT_FALSE(point.old.plastic);
  pull(point, 1 - 8e6 / E);
  EXPECT_TRUE(point.old.plastic);
  EXPECT_NEAR(point.old.stress[0], top - 2 * SIGMA_Y, 0.005 * SIGMA_Y);
}

TEST(Backstress, ArmstrongFrederickTendsToItsClosedForm) {
  // monotonic: q(X) = C/gamma (1 - exp(-gamma ep)), first order by backward Euler; the limit C/gamma exactly
  const double C = 2e10, gamma = 50;
  const auto error = [&](int n) {
    AnyLawPoint point(
        law_of({{"sigY", SIGMA_Y}, {"C", C}, {"gamma", gamma}}, "perfect", "armstrongfrederick"));
    for (int k = 0; k < n; ++k) pull(point, 1 + 0.03 / n);
    const double expected = C / gamma * (1 - std::exp(-gamma * point.old.plastic_strain_eq()));
    return std::abs(equivalent<2>(point.old.backstress()) - expected) / (C / gamma);
  };
  const double coarse = error(40), fine = error(80);
  EXPECT_NEAR(std::log2(coarse / fine), 1, 0.05);
  EXPECT_LT(fine, 0.01);
  for (StressUpdate update : {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED}) {
    AnyLawPoint point(
        law_of({{"sigY", SIGMA_Y}, {"C", C}, {"gamma", gamma}}, "perfect", "armstrongfrederick"), update);
    for (int k = 0; k < 40; ++k) pull(point, 1.05);
    EXPECT_NEAR(equivalent<2>(point.old.backstress()) / (C / gamma), 1, 1e-9);
    EXPECT_NEAR(point.old.stress[0] / (SIGMA_Y + C / gamma), 1, 1e-9);
  }
}

TEST(Backstress, WithoutRecoveryArmstrongFrederickIsPrager) {
  const LawNumbers numbers = {{"sigY", SIGMA_Y}, {"H", 1e9}, {"C", 4e9}};
  LawNumbers zero = numbers, tiny = numbers;
  zero["gamma"] = 0;
  tiny["gamma"] = 1e-12;
  AnyLawPoint prager(law_of(numbers, "linear", "prager")), same(law_of(zero, "linear", "armstrongfrederick")),
      near(law_of(tiny, "linear", "armstrongfrederick"));
  for (double shear : {0.01, 0.03, -0.02}) {
    for (AnyLawPoint* point : {&prager, &same, &near}) point->advance(tensor(1 + shear / 2, shear, 0, 1));
    EXPECT_EQ(prager.old.stress, same.old.stress);
    expect_close(near.old.stress, prager.old.stress, SIGMA_Y, 1e-10, "stress");
  }
}

TEST(Backstress, ARotationTurnsItInsideTheStep) { // stretch and spin: the angle is that of the stress
  AnyLawPoint point(law_of({{"sigY", SIGMA_Y}, {"C", 4e9}}, "perfect", "prager"));
  point.advance(tensor(1.02, 0.01, 0.01, 0.98));
  const Stress<2> X = point.old.backstress();
  const Tensor<2> F = rotation(0.5) * in_plane(point.old.F);
  point.old.stress *= 0.5; // inside: only turned
  point.advance(gradient(F, point.old.F[ZZ]));
  expect_close(point.old.backstress(), turned(X, rotation(0.5)), SIGMA_Y, 1e-13, "X");
}

TEST(Backstress, LoadsAndLoadingAreMeasuredFromIt) {
  AnyLawPoint point(law_of({{"sigY", SIGMA_Y}, {"C", 4e10}}, "perfect", "prager"));
  point.advance(tensor(1.01, 0, 0, 0.99));
  LawState at = point.old;
  at.plastic = false;
  const Stress<2> X = at.backstress(), xi = deviator<2>(at.stress) - X;
  ASSERT_GT(equivalent<2>(X), 1.1 * SIGMA_Y);
  EXPECT_TRUE(point.law->loads(at.view(), xi));
  at.stress = X - xi; // on the other side of the surface, where s and xi point to opposite sides
  ASSERT_GT(contract<2>(at.stress, xi), 0);
  EXPECT_NEAR(point.law->yield_distance(at.stress, at.internal.data()), 0, 1e-12);
  EXPECT_TRUE(point.law->loads(at.view(), -xi));
  EXPECT_FALSE(point.law->loads(at.view(), xi));
  point.old.stress = at.stress;
  EXPECT_LT(point.law->loading(point.step(tensor(1.011, 0, 0, 0.989))).now, 0);
  EXPECT_GT(point.law->loading(point.step(tensor(1.009, 0, 0, 0.991))).now, 0);
  EXPECT_EQ(point.law->yield_fraction(point.step(tensor(1.009, 0, 0, 0.991)), 1, 0), 0);
}

TEST(PerfectPlasticity, KeepsTheYieldStress) {
  for (const LawInput& input : {law_of({{"sigY", SIGMA_Y}}, "perfect", "none"),
                                law_of({{"sigY", SIGMA_Y}, {"H", 0}}, "linear", "none")})
    for (StressUpdate update : {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED}) {
      AnyLawPoint point(input, update);
      double strain = 0;
      for (double factor : {1.001, 1.01, 1.03}) {
        strain += pull(point, factor);
        const double sigma = std::min(E * strain, SIGMA_Y);
        EXPECT_NEAR(point.old.stress[0], sigma, 1e-7 * SIGMA_Y);
        EXPECT_NEAR(point.old.plastic_strain_eq(), strain - sigma / E, 1e-10);
      }
      EXPECT_LT(point.tangent_error(point.old.F + 0.01 * gradient(tensor(1, 0.3, 0, -1), 0)), 1e-7);
    }
}

TEST(Softening, RunsOnItsLineAndEndsByAStatus) {
  LawInput input = law_of({{"sigY", SIGMA_Y}, {"H", -1e9}}, "linear", "none");
  input.softening = true;
  AnyLawPoint point(input);
  pull(point, 1.03);
  const double strain = 2 * 0.03 / 2.03, ep = (E * strain - SIGMA_Y) / (E - 1e9);
  EXPECT_NEAR(point.old.stress[0], SIGMA_Y - 1e9 * ep, 1e-7 * SIGMA_Y);
  EXPECT_NEAR(point.old.plastic_strain_eq(), ep, 1e-10);
  LawState end;
  const PointResult result = point.update(tensor(1.5, 0, 0, 0.7), end); // no yield stress left at ep = 0.193
  EXPECT_EQ(result.status, UpdateStatus::NO_RETURN);
  EXPECT_EQ(result.value, point.old.plastic_strain_eq());
}

TEST(Softening, FallingFasterThanTheElasticStressIsAStatus) {
  LawInput input =
      law_of({}, "2e8 - 1.5e8*tanh(2000*(ep - 0.02))", "none"); // slope -3e11 at 0.02, 3G = 8.1e10
  input.softening = true;
  for (const char* backstress : {"none", "armstrongfrederick"}) {
    input.backstress = backstress;
    if (backstress != std::string("none")) input.numbers["C"] = 1e9, input.numbers["gamma"] = 5;
    AnyLawPoint point(input);
    pull(point, 1.005);
    LawState end;
    bool refused = false;
    for (int k = 0; k <= 100 && !refused; ++k) { // some of the steps end on the cliff
      const double stretch = 1.015 + 1e-4 * k, across = 1 / std::sqrt(stretch);
      refused = point.update(gradient(tensor(stretch, 0, 0, across), across), end).status ==
                UpdateStatus::NO_RETURN;
    }
    EXPECT_TRUE(refused) << backstress;
    EXPECT_EQ(point.update(gradient(tensor(1.008, 0, 0, 0.996), 0.996), end).status, UpdateStatus::OK);
  }
}

#include "unit/material/j2/point_walk.hpp"
#include <random>

using namespace burnish;
using namespace burnish::test;

namespace {

std::mt19937 generator(1);
double random_number() { return std::uniform_real_distribution<double>(-1, 1)(generator); }

Stress<2> random_deviator(double size) {
  return size * deviator<2>({random_number(), random_number(), random_number(), random_number()});
}

/// Random step: stress on or inside the surface, strain increment of up to `strain`, prior increment,
/// rotation.
PointWalk random_step(double strain, Tensor<2>& F) {
  PointWalk step;
  step.old.plastic_strain_eq = 0.1 * std::abs(random_number());
  step.old.F = gradient(Tensor<2>::Identity() +
                        0.2 * Tensor<2>::NullaryExpr([](auto, auto) { return random_number(); }));
  step.old.stress =
      random_number() * on_surface(step.material, random_deviator(1), step.old.plastic_strain_eq);
  step.old.strain_increment = random_deviator(strain);
  step.old.plastic = random_number() > 0;
  const Tensor<2> dU = strain * Tensor<2>::NullaryExpr([](auto, auto) { return random_number(); });
  F = (Tensor<2>::Identity() + dU) * in_plane(step.old.F);
  return step;
}

} // namespace

TEST(RadialReturn, InsideNothingHappens) {
  const J2Parameters material = example_material();
  const Stress<2> inside = 0.999999 * on_surface(material, {1, 2, -1, 3}, 0.1);
  Stress<2> s = inside;
  double plastic_strain_eq = 0.1;
  EXPECT_EQ(radial_return<2>(material, s, plastic_strain_eq), 0);
  EXPECT_EQ(s, inside);
  EXPECT_EQ(plastic_strain_eq, 0.1);
}

TEST(RadialReturn, EndsOnTheSurfaceAndDissipates) {
  for (double H : {0.0, 9.62e8})
    for (int trial = 0; trial < 200; ++trial) {
      const J2Parameters material = example_material(1.93e8, H);
      const double start = 0.2 * std::abs(random_number());
      const Stress<2> outside =
          (1 + 10 * std::abs(random_number())) * on_surface(material, random_deviator(1), start);
      Stress<2> s = outside;
      double plastic_strain_eq = start;
      const double increment = radial_return<2>(material, s, plastic_strain_eq);
      const double yield = material.yield_stress(plastic_strain_eq).value;
      EXPECT_GE(increment, 0);
      EXPECT_DOUBLE_EQ(plastic_strain_eq, start + increment);
      EXPECT_NEAR(equivalent<2>(s) / yield, 1, 1e-12);
      // dissipation s:d = q x, with the plastic strain increment that the return took off the trial
      const Stress<2> plastic_strain = (outside - s) / (2 * material.elastic.G);
      EXPECT_NEAR(contract<2>(s, plastic_strain), yield * increment, 1e-10 * yield * (increment + 1e-3));
    }
}

TEST(SubsteppedReturn, ConsistencyAndDissipationOfRandomSteps) {
  int plastic = 0;
  for (StressUpdate update : {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED})
    for (int trial = 0; trial < 500; ++trial) {
      Tensor<2> F;
      PointWalk step = random_step(0.03, F);
      step.scheme = {update, 1.5, 1, 1 + trial % 20};
      const J2End<2> now = step.at(F);
      const double q = equivalent<2>(deviator<2>(now.stress)),
                   yield = step.material.yield_stress(now.plastic_strain_eq).value;
      EXPECT_LE(q, yield * (1 + 1e-12));
      EXPECT_GE(now.plastic_strain_eq, step.old.plastic_strain_eq);
      EXPECT_EQ(now.plastic, now.plastic_strain_eq > step.old.plastic_strain_eq);
      const bool last_returned = update == StressUpdate::SINGLE && now.plastic;
      if (last_returned) {
        EXPECT_NEAR(q / yield, 1, 1e-12);
      }
      plastic += now.plastic;
    }
  EXPECT_GT(plastic, 500);
}

TEST(SubsteppedReturn, MeanStressIsElastic) {
  for (int trial = 0; trial < 50; ++trial) {
    Tensor<2> F;
    PointWalk step = random_step(0.03, F);
    step.old.stress.head<3>().array() += 3e8;
    step.scheme = {StressUpdate::SUBSTEPPED, 1.5, 1, 5};
    const double volume = step.kinematics(F).strain.head<2>().sum();
    EXPECT_NEAR(mean<2>(step.at(F).stress), mean<2>(step.old.stress) + step.material.elastic.K * volume,
                1e-5);
  }
}

TEST(SubsteppedReturn, EndPointOfAnElasticPathIsExact) {
  for (int substeps : {3, 7, 20}) {
    Tensor<2> F;
    PointWalk step = random_step(0.01, F);
    step.material = example_material(1e15);
    step.scheme = {StressUpdate::SUBSTEPPED, 1e3, 1.3, substeps};
    const Stress<2> substepped = step.at(F).stress;
    step.scheme.substeps = 0;
    expect_close(substepped, step.at(F).stress, step.material.elastic.G, 1e-15, "stress");
  }
}

TEST(SubsteppedReturn, ProportionalPathEqualsTheSingleReturn) {
  // radial and monotone, linear hardening: the return is exact, the plastic increment (q(De) + q_old -
  // sigma_0)/(3G + H')
  PointWalk step;
  const J2Parameters& material = step.material;
  const Tensor<2> F = tensor(1.02, 0.01, 0.01, 0.985);
  const StepKinematics<2> kin = step.kinematics(F);
  const Stress<2> elastic_increment = deviatoric_stress<2>(material.elastic, kin.strain);
  const double yield = material.yield_stress(0).value, H = material.yield_stress(0).slope;
  step.old.stress = 0.5 * on_surface(material, elastic_increment, 0);
  step.old.strain_increment = kin.strain / 3;
  const double expected = (equivalent<2>(elastic_increment) - 0.5 * yield) / (3 * material.elastic.G + H);
  const Stress<2> end = on_surface(material, elastic_increment, expected);
  for (StressUpdate update : {StressUpdate::SINGLE, StressUpdate::SUBSTEPPED})
    for (double ratio : {0.0, 3.0, 0.7})
      for (int substeps : {1, 3, 20}) {
        step.scheme = {update, 1e9, ratio, substeps};
        if (ratio == 0.7)
          step.scheme.path_limit = 0; // another rate before, but the path straight by its limit
        EXPECT_NEAR(step.at(F).plastic_strain_eq, expected, 1e-14);
        expect_close(deviator<2>(step.at(F).stress), end, yield, 1e-12, "deviator");
      }
}

TEST(SubsteppedReturn, NumberOfSubsteps) {
  const J2Parameters material = example_material();
  UpdateOptions options;
  ElasticTrial<2> trial;
  const auto needed = [&](double fraction_old, double fraction, double plastic_strain_eq, bool plastic) {
    trial.s_old = fraction_old * on_surface(material, {1, -1, 0, 0}, plastic_strain_eq);
    trial.elastic_increment = fraction * on_surface(material, {1, -1, 0, 0}, plastic_strain_eq);
    return substeps_needed<2>(material, options, trial, plastic_strain_eq, plastic);
  };
  EXPECT_EQ(needed(0.5, 0.4, 0.1, false), 0); // inside
  EXPECT_EQ(needed(0.5, -0.4, 0.1, true), 3); // unloads, but flowed in the last step
  EXPECT_EQ(needed(0.5, 0.6, 0.1, false), 3); // outside: at least three
  EXPECT_EQ(needed(1, 1.49, 0.1, false), 5);  // ceil(1.49/0.3)
  EXPECT_EQ(needed(1, 1.51, 0.1, false), 6);
  EXPECT_EQ(needed(1, 1e9, 0.1, false), 20);   // at most twenty
  EXPECT_EQ(needed(1, 1e300, 0.1, false), 20); // q^2 overflows, the number does not
  options.max_substeps = 7;
  EXPECT_EQ(needed(1, 2.11, 0.1, false), 7); // ceil(2.11/0.3) is 8
}

TEST(UpdatedPoint, ObjectiveUnderASuperposedRotation) {
  for (StressUpdate update : {StressUpdate::SUBSTEPPED, StressUpdate::SINGLE, StressUpdate::FORWARD_EULER})
    for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END})
      for (double angle : {-2.0, 0.1, 1.4}) {
        Tensor<2> F;
        PointWalk step = random_step(0.03, F);
        step.frame = frame;
        step.scheme = {update, 1.5, 1, 6};
        step.old.stress *= 1.5; // FORWARD_EULER: on or outside the surface too
        const J2End<2> here = step.at(F);
        const Tensor<2> Q = rotation(angle);
        step.old.F = gradient(Q * in_plane(step.old.F));
        step.old.stress = turned(step.old.stress, Q);
        step.old.strain_increment = turned(step.old.strain_increment, Q);
        const J2End<2> there = step.at(Q * F);
        expect_close(there.stress, turned(here.stress, Q), step.material.yield_stress(0).value, 1e-12,
                     "stress");
        EXPECT_NEAR(there.plastic_strain_eq, here.plastic_strain_eq, 1e-14);
      }
}

TEST(UpdatedPoint, SameInPascalAndInMegapascal) {
  for (StressUpdate update : {StressUpdate::SUBSTEPPED, StressUpdate::SINGLE, StressUpdate::FORWARD_EULER}) {
    Tensor<2> F;
    PointWalk step = random_step(0.03, F);
    step.old.stress = on_surface(step.material, {1, -1, 0, 0.5}, step.old.plastic_strain_eq);
    step.scheme = {update, 1.5, 1, 6};
    const J2End<2> pascal = step.at(F);
    step.material = J2Parameters::from_shear(2.7e4, 0.32, 193, 962);
    step.old.stress *= 1e-6;
    const J2End<2> mega = step.at(F);
    expect_close(1e6 * mega.stress, pascal.stress, pascal.stress.norm(), 1e-13, "stress");
    EXPECT_NEAR(mega.plastic_strain_eq, pascal.plastic_strain_eq, 1e-15);
  }
}

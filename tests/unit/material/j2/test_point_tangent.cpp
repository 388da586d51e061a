// Tangents of the first Piola stress, unsymmetrized, against finite differences.
#include "unit/material/j2/point_walk.hpp"
#include <limits>
#include <vector>

using namespace burnish;
using namespace burnish::test;

namespace {

const double UNLIMITED = std::numeric_limits<double>::infinity();

struct Case {
  std::string name;
  PointWalk step;
  Gradient<2> F;
  bool plastic; // expected
};

/// F_old stretched and turned, stress of a fraction of the yield stress with a mean part.
/// @param hoop stretch out of the plane over that in it: 0 in plane strain
PointWalk stressed(double fraction, double hoop = 0) {
  PointWalk step;
  step.old.F = gradient(tensor(1.1, 0.2, -0.15, 0.95), 1 + 0.1 * hoop);
  step.old.plastic_strain_eq = 0.05;
  step.old.stress = fraction * on_surface(step.material, {1, -0.2, -0.8, 0.9}, 0.05);
  step.old.stress.head<3>().array() -= 2e8;
  step.old.strain_increment = {0.004, -0.003, 0.004 * hoop, -0.005};
  return step;
}

Gradient<2> moved(const PointWalk& step, double strain, double angle, double hoop = 0) {
  const Tensor<2> stretch = Tensor<2>::Identity() + strain * tensor(1, 0.6, 0.4, -0.7);
  return gradient(rotation(angle) * stretch * in_plane(step.old.F), (1 + hoop * strain) * step.old.F[ZZ]);
}

std::vector<Case> cases() {
  std::vector<Case> list;
  const auto add = [&](const std::string& name, double fraction, double strain, double angle, bool plastic) {
    for (double hoop : {0., -0.6, 0.8}) {
      const PointWalk step = stressed(fraction, hoop);
      list.push_back(
          {name + ", hoop " + std::to_string(hoop), step, moved(step, strain, angle, hoop), plastic});
    }
  };
  add("elastic, no stress", 0, 1e-3, 0, false);
  add("elastic, stress and rotation", 0.5, 1e-3, 0.2, false);
  add("unloading from the surface", 1, -1e-3, 0.05, false);
  add("just plastic", 0.9, 3e-3, 0.01, true);
  add("plastic, from the surface, with rotation", 1, 4e-3, 0.2, true);
  add("strongly plastic", 0.5, 0.1, 0, true);
  add("strongly plastic with rotation", 1, 0.2, -0.5, true);
  add("reversed through the whole surface", 1, -0.05, 0.1, true);
  return list;
}

void check_tangent(const Case& c, const PointWalk& step) {
  ASSERT_EQ(step.at(c.F).plastic, c.plastic);
  const PiolaTangent<2> computed = step.tangent(c.F), measured = step.measured_tangent(c.F, 1e-6);
  const double error = (computed - measured).norm() / measured.norm();
  EXPECT_LE(error, 1e-9) << "computed\n" << computed << "\nmeasured\n" << measured;
}

} // namespace

TEST(PointTangent, SingleReturn) {
  for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END})
    for (const Case& c : cases()) {
      SCOPED_TRACE(c.name);
      PointWalk step = c.step;
      step.frame = frame;
      step.scheme.update = StressUpdate::SINGLE;
      check_tangent(c, step);
    }
}

TEST(PointTangent, SubsteppedReturn) {
  for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END})
    for (double limit : {1.5, 0.0, UNLIMITED}) // limiter active in some steps, always, never
      for (int substeps : {1, 3, 20})
        for (const Case& c : cases()) {
          if (!c.plastic) continue;
          SCOPED_TRACE(c.name + ", limit " + std::to_string(limit) + ", substeps " +
                       std::to_string(substeps));
          PointWalk step = c.step;
          step.frame = frame;
          step.scheme = {StressUpdate::SUBSTEPPED, limit, 0.8, substeps};
          check_tangent(c, step);
        }
}

TEST(PointTangent, SubsteppedElasticStep) {
  for (const Case& c : cases()) {
    if (c.plastic) continue;
    SCOPED_TRACE(c.name);
    PointWalk step = c.step;
    step.scheme = {StressUpdate::SUBSTEPPED, 1.5, 0.8, 0};
    check_tangent(c, step);
  }
}

TEST(PointTangent, PathThatFlowsInsideAndComesBack) {
  // the end of the straight path is inside the surface, the quadratic path is not: only some substeps flow
  PointWalk step = stressed(0.95);
  step.old.strain_increment = {0.02, -0.012, 0, 0.015};
  step.scheme = {StressUpdate::SUBSTEPPED, UNLIMITED, 1, 7};
  const Case c{"out and back", step, moved(step, -1e-3, 0.02), true};
  const ElasticTrial<2> trial = step.trial(c.F);
  ASSERT_EQ(substeps_needed<2>(step.material, {}, trial, step.old.plastic_strain_eq, false), 0);
  check_tangent(c, step);
}

TEST(PointTangent, ForwardEuler) {
  int plastic = 0;
  for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END})
    for (const Case& c : cases()) {
      SCOPED_TRACE(c.name);
      PointWalk step = c.step;
      step.frame = frame;
      step.scheme.update = StressUpdate::FORWARD_EULER;
      const PiolaTangent<2> computed = step.tangent(c.F), measured = step.measured_tangent(c.F, 1e-6);
      EXPECT_LE((computed - measured).norm() / measured.norm(), 1e-8) << computed << "\nmeasured\n"
                                                                      << measured;
      plastic += step.at(c.F).plastic;
    }
  EXPECT_GE(plastic, 12); // from the surface, loading
}

TEST(PointTangent, Nonsymmetry) { // why its symmetric part may be used: METHOD.md 1.6
  PointWalk step = stressed(1);
  const auto nonsymmetry = [&](StressUpdate update, StrainFrame frame) {
    step.frame = frame;
    step.scheme = {update, 1.5, 1, 5};
    const PiolaTangent<2> A = step.tangent(moved(step, 0.005, 0.01));
    return (A - A.transpose()).norm() / A.norm();
  };
  // a single return is the gradient of a potential but for the frame of its strain increment
  EXPECT_NEAR(nonsymmetry(StressUpdate::SINGLE, StrainFrame::MIDPOINT), 2e-3, 1e-3);
  EXPECT_LT(nonsymmetry(StressUpdate::SINGLE, StrainFrame::END), 2e-5);
  // substeps that turn are not
  EXPECT_LT(nonsymmetry(StressUpdate::SUBSTEPPED, StrainFrame::MIDPOINT), 3.5e-2);
  EXPECT_LT(nonsymmetry(StressUpdate::SUBSTEPPED, StrainFrame::END), 3.5e-2);
}

TEST(RateTangent, IsSymmetric) {
  for (const Case& c : cases())
    for (bool plastic : {false, true}) {
      const PiolaTangent<2> A = rate_tangent<2>(c.step.material, c.step.old.stress, 0.05, c.F, plastic);
      EXPECT_LE((A - A.transpose()).norm(), 1e-14 * A.norm()) << c.name;
    }
}

TEST(RateTangent, IsTheLimitOfTheSingleReturn) {
  for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END})
    for (bool plastic : {false, true}) {
      SCOPED_TRACE(plastic ? "loading" : "unloading");
      PointWalk step = stressed(1);
      step.frame = frame;
      step.scheme.update = StressUpdate::SINGLE;
      const PiolaTangent<2> limit =
          rate_tangent<2>(step.material, step.old.stress, 0.05, step.old.F, plastic);
      double error_before = 0;
      for (double size : {4e-6, 2e-6, 1e-6}) {
        const Gradient<2> F = moved(step, plastic ? size : -size, 10 * size);
        ASSERT_EQ(step.at(F).plastic, plastic);
        const double error = (step.tangent(F) - limit).norm() / limit.norm();
        EXPECT_LE(error, 1e3 * size) << "step " << size;
        if (error_before > 0) {
          EXPECT_NEAR(error_before / error, 2, 0.1) << "step " << size;
        } // first order
        error_before = error;
      }
    }
}

TEST(RateTangent, IsTheWorkOfTheRates) {
  // dF:dP = dL_ij (D:d + w tau - tau d)_ij with dF = L F, METHOD.md (1.8); w has no hoop part
  const J2Parameters material = example_material();
  const PointWalk step = stressed(1, 0.7);
  const Gradient<2> F = step.old.F, rates = gradient(tensor(0.3, -0.5, 0.9, 0.2), 0.4),
                    test = gradient(tensor(-0.4, 0.1, 0.8, 0.7), -0.6);
  const Tensor<2> L = in_plane(rates), dL = in_plane(test);
  const Tensor<2> d = (L + L.transpose()) / 2, w = (L - L.transpose()) / 2;
  const Stress<2> rate = {d(0, 0), d(1, 1), rates[ZZ], d(0, 1)}, s = deviator<2>(step.old.stress);
  const double q = equivalent<2>(s);
  const double G = material.elastic.G, H = 9.62e8;
  Stress<2> Dd = deviatoric_stress<2>(material.elastic, rate) -
                 3 * G * contract<2>(s, rate) / (q * q * (1 + H / (3 * G))) * s;
  Dd.head<3>().array() += material.elastic.K * (d.trace() + rates[ZZ]);
  const Tensor<2> tau = in_plane(step.old.stress);
  const double expected = (dL.array() * (in_plane(Dd) + w * tau - tau * d).array()).sum() +
                          test[ZZ] * (Dd[2] - step.old.stress[2] * rates[ZZ]);
  const PiolaTangent<2> A = rate_tangent<2>(material, step.old.stress, 0.05, F, true);
  EXPECT_NEAR(product(test, F).dot(A * product(rates, F)) / expected, 1, 1e-13);
}

TEST(PiolaTangent, PushOfAConstantStress) { // tau frozen: dP = tau d(F^-T)
  const Stress<2> stress = {3, -1, 7, 2};
  const Gradient<2> F = gradient(tensor(1.2, 0.3, -0.2, 0.9), 1.4);
  const PiolaTangent<2> A = piola_tangent<2>(StressByF<2>::Zero(), stress, inverse(F));
  for (int c = 0; c < 5; ++c) {
    const auto P = [&](double t) {
      return first_piola(stress, inverse(Gradient<2>(F + t * Gradient<2>::Unit(c))));
    };
    expect_close(A.col(c), finite_difference(P, 0, 1e-3), 1, 1e-9, "dP/dF");
  }
}

TEST(PiolaTangent,
     StressOutOfThePlane) { // P_zz = tau_zz/F_zz, and the force in the plane knows nothing of it
  const Gradient<2> F_inverse = inverse(gradient(tensor(1.2, 0.3, -0.2, 0.9), 1.6));
  EXPECT_DOUBLE_EQ(first_piola({3, -1, 8, 2}, F_inverse)[ZZ], 5);
  EXPECT_EQ(first_piola({0, 0, 8, 0}, F_inverse).head<4>().norm(), 0);
}

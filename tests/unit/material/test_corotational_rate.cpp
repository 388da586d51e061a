// The corotational rates: angles of rigid rotations, linearizations, and hypoelastic simple shear against closed forms.
#include "unit/material/j2/law_point.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr CorotationalRate RATES[] = {CorotationalRate::JAUMANN, CorotationalRate::GREEN_NAGHDI,
                                      CorotationalRate::LOGARITHMIC};
constexpr const char* NAMES[] = {"jaumann", "greennaghdi", "logarithmic"};
constexpr StrainFrame FRAMES[] = {StrainFrame::MIDPOINT, StrainFrame::END};

/// Stress over G of simple shear F = [1, gamma; 0, 1]: xx = -yy, and xy.
struct Shear {
  double xx, xy;
};
Shear closed_form(CorotationalRate rate, double gamma) {
  if (rate == CorotationalRate::JAUMANN) return {1 - std::cos(gamma), std::sin(gamma)};
  const double beta = std::atan(gamma / 2), log_cos = std::log(std::cos(beta));
  if (rate == CorotationalRate::GREEN_NAGHDI) // [Dienes1979]
    return {4 * (std::cos(2 * beta) * log_cos + beta * std::sin(2 * beta) - std::pow(std::sin(beta), 2)),
            2 * std::cos(2 * beta) * (2 * beta - 2 * std::tan(2 * beta) * log_cos - std::tan(beta))};
  const double log_stretch = std::asinh(gamma / 2), s = std::sqrt(1 + gamma * gamma / 4); // 2G ln V
  return {gamma * log_stretch / s, 2 * log_stretch / s};
}

/// Largest error over G along the shear to 8 in n steps; `least` the least xy over G met.
double shear_error(const char* rate, CorotationalRate kind, int n, double* least = nullptr) {
  const double G = 2.7e10;
  LawInput input{with_example_elasticity({{"sigY", 1e3 * G}})};
  input.hardening = "perfect";
  input.rate = rate;
  AnyLawPoint point(input);
  double error = 0;
  for (int k = 1; k <= n; ++k) {
    const double gamma = 8. * k / n;
    point.advance(tensor(1, gamma, 0, 1));
    const Shear exact = closed_form(kind, gamma);
    const Stress<2>& stress = point.old.stress;
    error = std::max(error, std::hypot(stress[0] / G - exact.xx, stress[3] / G - exact.xy));
    EXPECT_NEAR(stress[0], -stress[1], 1e-10 * G);
    if (least) *least = std::min(*least, stress[3] / G);
  }
  return error;
}

} // namespace

TEST(CorotationalRate, SimpleShearAgainstClosedFormsIsSecondOrder) {
  for (int r = 0; r < 3; ++r) {
    SCOPED_TRACE(NAMES[r]);
    double least = 0;
    const double coarse = shear_error(NAMES[r], RATES[r], 200),
                 fine = shear_error(NAMES[r], RATES[r], 400, &least);
    RecordProperty(std::string("error_of_400_steps_") + NAMES[r], std::to_string(fine));
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.02) << coarse << ", " << fine;
    EXPECT_LT(fine, 2e-4);
    EXPECT_EQ(least < -0.9, RATES[r] == CorotationalRate::JAUMANN)
        << "only the Jaumann stress changes its sign";
  }
}

TEST(CorotationalRate, RigidRotationIsExactForAnyAngle) {
  const Tensor<2> F_old = tensor(1.5, 0.6, -0.1, 0.7);
  for (CorotationalRate rate : RATES)
    for (StrainFrame frame : FRAMES)
      for (double angle : {-3.0, -0.3, 1e-9, 0.3, 1.0, 3.0}) {
        const StepKinematics<2> kin =
            step_kinematics(gradient(F_old), gradient(rotation(angle) * F_old), frame, rate);
        EXPECT_LE(kin.strain.norm(), 1e-14 * (1 + std::abs(kin.spin)));
        EXPECT_NEAR(kin.cos_alpha, std::cos(angle), 1e-13) << "angle " << angle;
        EXPECT_NEAR(kin.sin_alpha, std::sin(angle), 1e-13) << "angle " << angle;
        EXPECT_NEAR(kin.sin_2alpha, std::sin(2 * angle), 2e-13) << "angle " << angle;
      }
}

TEST(CorotationalRate, GreenNaghdiIsThePolarRotation) {
  const Tensor<2> F_old = rotation(0.4) * tensor(1.2, 0.1, 0.1, 0.8),
                  F = rotation(1.1) * tensor(0.7, 0.3, 0.3, 1.9);
  const PlaneRotation turn = polar_rotation(gradient(F_old), gradient(F));
  EXPECT_NEAR(turn.cos, std::cos(0.7), 1e-15);
  EXPECT_NEAR(turn.sin, std::sin(0.7), 1e-15);
}

TEST(CorotationalRate, LogarithmicExcessAgainstItsDefinition) {
  // (d h - h d)_21 L(x)/x with h = ln V, x = h_1 - h_2, L(x) = coth x - 1/x, on both sides of the series' end
  const Stress<2> d = {0.3, -0.5, 0.2, 0.7};
  for (double stretch : {1.1, 1.2499, 1.26, 2., 30.})
    for (double angle : {0.2, 1.3}) {
      const Tensor<2> V = rotation(angle) * tensor(stretch, 0, 0, 1 / stretch) * rotation(-angle);
      const Tensor<2> h =
          rotation(angle) * tensor(std::log(stretch), 0, 0, -std::log(stretch)) * rotation(-angle);
      const double x = 2 * std::log(stretch);
      const Tensor<2> D = in_plane(d), commutator = D * h - h * D;
      const double expected = commutator(1, 0) * (1 / std::tanh(x) - 1 / x) / x;
      EXPECT_NEAR(logarithmic_excess(gradient(V * rotation(0.9)), d) / expected, 1, 1e-12) << stretch;
    }
  EXPECT_EQ(logarithmic_excess(undeformed<2>(), d), 0);
}

TEST(CorotationalRate, LinearizationAgainstFiniteDifferences) {
  using Increments = Eigen::Matrix<double, 5, 1>;
  const Gradient<2> F_old = gradient(tensor(1.1, 0.2, -0.1, 0.9), 1.1);
  const Gradient<2> ends[] = {F_old, gradient(tensor(1.15, 0.1, 0.05, 0.95), 0.9),
                              gradient(rotation(0.8) * tensor(1.3, 0.2, 0, 0.8), 1.4),
                              gradient(rotation(-0.6) * tensor(3, 1.2, 0.4, 0.9), 0.7)};
  for (CorotationalRate rate : RATES)
    for (StrainFrame frame : FRAMES)
      for (const Gradient<2>& F : ends) {
        const auto increments = [&](const Gradient<2>& at) {
          const StepKinematics<2> kin = step_kinematics(F_old, at, frame, rate);
          Increments y;
          y << kin.strain, std::atan2(kin.sin_alpha, kin.cos_alpha);
          return y;
        };
        IncrementByF<2> measured;
        for (int c = 0; c < 5; ++c)
          measured.col(c) =
              finite_difference([&](double t) { return increments(F + t * Gradient<2>::Unit(c)); }, 0, 1e-3);
        expect_close(finite_increment_by_F(step_kinematics(F_old, F, frame, rate)), measured, 1, 1e-9,
                     "dy/dF");
      }
}

TEST(CorotationalRate, RateIsTheLimitOfAVanishingStep) {
  const Gradient<2> F = gradient(tensor(1.4, 0.5, -0.1, 0.8), 1.3);
  for (CorotationalRate rate : RATES)
    for (StrainFrame frame : FRAMES)
      expect_close(rate_by_F(F, inverse(F), rate), finite_increment_by_F(step_kinematics(F, F, frame, rate)),
                   1, 1e-14, "dy/dF");
}

TEST(CorotationalRate, Errors) {
  expect_invalid(
      [] { corotational_rate("truesdell", "here"); },
      "here: unknown rate \"truesdell\", expected one of \"jaumann\", \"greennaghdi\", \"logarithmic\"");
}

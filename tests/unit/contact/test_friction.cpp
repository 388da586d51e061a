// Friction laws: values, slopes against finite differences over decades, switches, bad input.
#include "contact/formula_friction.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>
#include <limits>

using namespace burnish;
using namespace burnish::test;

namespace {

using Law = std::shared_ptr<const FrictionLaw>;
constexpr double INF = std::numeric_limits<double>::infinity();

/// Steel on steel in Pa; pressures where each law is far from its switch.
struct Case {
  const char* name;
  Law law;
  double (*traction)(double p); ///< written down once more
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"none", make_coulomb(0), [](double) { return 0.; }},
      {"Coulomb", make_coulomb(0.3), [](double p) { return 0.3 * p; }},
      {"Tresca", make_tresca(5e7), [](double) { return 5e7; }},
      {"limited", make_limited_coulomb(0.3, 1e8), [](double p) { return std::min(0.3 * p, 1e8); }},
      {"formula", make_formula_friction("mu*p/(1 + p/p0)", {{"mu", 0.3}, {"p0", 4e8}}),
       [](double p) { return p > 0 ? 0.3 * p / (1 + p / 4e8) : 0.3 * p; }},
      {"adhesive", make_formula_friction("2e6 + 1e8*tanh(0.2*p/1e8)"),
       [](double p) { return 2e6 + (p > 0 ? 1e8 * std::tanh(0.2 * p / 1e8) : 0.2 * p); }},
  };
  return all;
}

const double AREAS[] = {1e-9, 3e-5, 1., 2e3};

/// Pressures over decades, of both signs; none within 10 % of the limited law's kink at 3.33e8.
std::vector<double> pressures() {
  std::vector<double> list;
  for (double p = 1e-2; p < 1e13; p *= 10)
    for (const double sign : {1., -1.}) list.push_back(sign * p);
  return list;
}

} // namespace

TEST(Friction, LimitIsTheTractionOfTheNodesShare) {
  for (const Case& c : cases())
    for (const double A : AREAS)
      for (const double p : pressures()) {
        const double expected = A * c.traction(p);
        EXPECT_NEAR(c.law->limit(A * p, A), expected, 1e-14 * std::abs(expected))
            << c.name << " p " << p << " A " << A;
      }
}

TEST(Friction, SlopeAgainstFiniteDifferences) {
  for (const Case& c : cases())
    for (const double A : AREAS)
      for (const double p : pressures()) {
        const auto limit = [&](double N) { return c.law->limit(N, A); };
        const double N = A * p, step = 1e-3 * std::abs(N);
        // rounding of g over the step, and the formula's fifth derivative
        const double tolerance = 1e-10 + 4e-16 * std::abs(limit(N)) / step;
        EXPECT_NEAR(c.law->slope(N, A), finite_difference(limit, N, step), tolerance)
            << c.name << " p " << p << " A " << A;
      }
}

TEST(Friction, ContinuousWithSlopeThroughZeroPressure) {
  for (const Case& c : cases()) {
    const double A = 2e-3, tiny = 1e-6, at = c.law->limit(0, A), slope = c.law->slope(0, A);
    EXPECT_GE(at, 0) << c.name;
    for (const double N : {tiny, -tiny}) {
      EXPECT_NEAR(c.law->limit(N, A), at + slope * N, 1e-11 * tiny + 1e-15 * at) << c.name;
      EXPECT_NEAR(c.law->slope(N, A), slope, 1e-11) << c.name;
    }
  }
}

TEST(Friction, LimitedCoulombAtItsKink) {
  const Law law = make_limited_coulomb(0.25, 8);
  const double A = 3, kink = A * 8 / 0.25; // p = 32
  EXPECT_DOUBLE_EQ(law->limit(kink, A), 24);
  EXPECT_EQ(law->slope(kink, A), 0.25);
  EXPECT_EQ(law->slope(kink * (1 + 1e-12), A), 0);
  EXPECT_DOUBLE_EQ(law->limit(2 * kink, A), 24);
  EXPECT_DOUBLE_EQ(law->limit(kink / 2, A), 12);
  EXPECT_DOUBLE_EQ(law->limit(-kink, A), -24); // as Coulomb
  EXPECT_EQ(law->slope(-kink, A), 0.25);
}

// g(c N, c A) = c g(N, A): nodes of a finer mesh sum up to the same traction. In mm, N and MPa too.
TEST(Friction, ShareAndUnitsDoNotMatter) {
  const Law in_MPa[] = {make_coulomb(0.3), make_tresca(50), make_limited_coulomb(0.3, 100),
                        make_formula_friction("mu*p/(1 + p/p0)", {{"mu", 0.3}, {"p0", 400}})};
  const Law in_Pa[] = {cases()[1].law, cases()[2].law, cases()[3].law, cases()[4].law};
  for (int i = 0; i < 4; ++i)
    for (const double p : pressures()) {
      const double A = 1e-3, whole = in_Pa[i]->limit(A * p, A); // m, N/m
      EXPECT_NEAR(4 * in_Pa[i]->limit(A * p / 4, A / 4), whole, 1e-14 * std::abs(whole));
      EXPECT_NEAR(1e3 * in_MPa[i]->limit(p * 1e-6 * A * 1e3, A * 1e3), whole, 1e-13 * std::abs(whole));
    }
}

TEST(Friction, Sticking) {
  const StickingFriction law;
  for (const double N : {-1e9, 0., 1e-9, 1e12}) {
    EXPECT_EQ(law.limit(N, 1e-3), INF);
    EXPECT_EQ(law.slope(N, 1e-3), 0);
  }
  EXPECT_TRUE(law.sticks_always());
  EXPECT_FALSE(law.frictionless());
  for (const Case& c : cases()) EXPECT_FALSE(c.law->sticks_always()) << c.name;
}

TEST(Friction, ZeroIsNoFriction) {
  for (const Law& law : {make_coulomb(0), make_tresca(0), make_limited_coulomb(0, 5),
                         make_limited_coulomb(0.3, 0), make_formula_friction("0"),
                         make_formula_friction("0*p"), make_formula_friction("mu*p", {{"mu", 0}})}) {
    EXPECT_TRUE(law->frictionless());
    EXPECT_EQ(law->limit(7, 2), 0);
    EXPECT_EQ(law->slope(7, 2), 0);
  }
  for (std::size_t i = 1; i < cases().size(); ++i) EXPECT_FALSE(cases()[i].law->frictionless());
  EXPECT_FALSE(make_formula_friction("5")->frictionless()) << "Tresca's law as a formula";
}

TEST(Friction, BadNumbers) {
  for (const double bad : {-0.3, std::nan(""), INF, -INF}) {
    EXPECT_THROW(make_coulomb(bad), std::invalid_argument);
    EXPECT_THROW(make_tresca(bad), std::invalid_argument);
    EXPECT_THROW(make_limited_coulomb(bad, 1), std::invalid_argument);
    EXPECT_THROW(make_limited_coulomb(0, bad), std::invalid_argument);
  }
  expect_invalid([] { make_coulomb(-0.3); }, "CoulombFriction: mu = -0.3, expected mu >= 0");
  expect_invalid([] { make_tresca(-5); },
                 "TrescaFriction: tresca traction k = -5, expected tresca traction k >= 0");
  expect_invalid([] { make_limited_coulomb(0.2, -7); }, "shear limit k = -7, expected shear limit k >= 0");
}

TEST(Friction, BadFormulas) {
  expect_invalid([] { FormulaFriction("0.3*"); }, "friction law \"0.3*\": the formula ends too early");
  expect_invalid([] { FormulaFriction("mu*p"); },
                 "friction law \"mu*p\": at character 1: unknown name \"mu\"");
  expect_invalid([] { FormulaFriction("0.3*p", {{"p", 1.}}); }, "name \"p\" occurs twice");
  expect_invalid([] { FormulaFriction("0.3*p - 20"); },
                 "friction law \"0.3*p - 20\": -20 at p = 0, expected a traction >= 0");
  expect_invalid([] { FormulaFriction("sqrt(p)"); }, "friction law \"sqrt(p)\", derivative by p");
  expect_invalid([] { FormulaFriction("1/p"); }, "friction law \"1/p\"");
}

TEST(Friction, FormulaOutsideItsRange) {
  const FormulaFriction turns("0.5*p*(1 - p/8)");
  EXPECT_DOUBLE_EQ(turns.limit(4 * 3, 3), 3);
  expect_invalid([&] { turns.limit(10 * 3, 3); },
                 "friction law \"0.5*p*(1 - p/8)\": -1.25 at p = 10, expected a traction >= 0");
  const FormulaFriction pole("p/(4 - p)");
  expect_invalid([&] { pole.limit(4, 1); }, "p/(4 - p)");
  EXPECT_TRUE(std::isnan(turns.limit(std::nan(""), 1))) << "a failed iteration is recognized by its force";
  EXPECT_FALSE(std::isfinite(turns.limit(INF, 1)));
  EXPECT_DOUBLE_EQ(turns.limit(-6, 1), -3);
  EXPECT_EQ(turns.slope(-6, 1), 0.5);
}

// Hardening by formula and by table, what of it is refused, and softening.
#include "material/formula_hardening.hpp"
#include "material/make_law.hpp"
#include "material/tabulated_hardening.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>

using namespace burnish;
using burnish::test::expect_invalid;

namespace {

std::shared_ptr<const HardeningLaw> formula(const std::string& text, bool softening = false) {
  return formula_hardening(text, softening, "here");
}
std::shared_ptr<const HardeningLaw> table(const std::vector<double>& strain,
                                          const std::vector<double>& stress, bool softening = false) {
  return tabulated_hardening(strain, stress, softening, "here");
}
std::shared_ptr<const MaterialLaw<2>> law(LawInput input) {
  input.numbers["E"] = 2.1e11;
  input.numbers["nu"] = 0.3;
  return make_law<2>(input, "here");
}

} // namespace

TEST(FormulaHardening, ValueAndExactSlope) {
  const auto swift = formula("193e6*(1 + ep/0.002)^0.2");
  EXPECT_FALSE(swift->is_linear());
  for (double ep : {0., 1e-4, 0.05, 3.}) {
    const double base = 1 + ep / 0.002;
    EXPECT_NEAR(swift->at(ep).value / (193e6 * std::pow(base, 0.2)), 1, 1e-14);
    EXPECT_NEAR(swift->at(ep).slope / (193e6 * 0.2 * std::pow(base, -0.8) / 0.002), 1, 1e-13);
  }
  EXPECT_EQ(formula("5e6")->at(0.3).value, 5e6) << "perfect";
  EXPECT_EQ(formula("5e6")->at(0.3).slope, 0);
}

// Ludwik, Johnson and Cook: an infinite slope at the start; returns of any size end on the law.
TEST(FormulaHardening, SteepStart) {
  const auto ludwik = formula("50e6 + 100e6*ep^0.2");
  EXPECT_EQ(ludwik->at(0).value, 50e6);
  EXPECT_NEAR(ludwik->at(0).slope, 100e6 * std::pow(STEEP_START, -0.8), 1);
  for (double ep : {STEEP_START, 1e-4, 0.05, 3.}) {
    EXPECT_NEAR(ludwik->at(ep).value / (50e6 + 100e6 * std::pow(ep, 0.2)), 1, 1e-14);
    EXPECT_NEAR(ludwik->at(ep).slope / (20e6 * std::pow(ep, -0.8)), 1, 1e-13);
  }
  const double below = STEEP_START * (1 - 1e-9);
  EXPECT_NEAR(ludwik->at(below).value / ludwik->at(STEEP_START).value, 1, 1e-9) << "continuous";
  for (double excess : {1e-9, 1e-3, 0.1, 1., 10.}) {
    const double q = 50e6 * (1 + excess), x = local_solve(*ludwik, 0, q, 2e11, excess);
    EXPECT_NEAR(q - 2e11 * x, ludwik->at(x).value, 1e-13 * q);
  }
}

TEST(FormulaHardening, Errors) {
  expect_invalid([] { formula("193e6*(1 + eps)"); }, "eps");
  expect_invalid([] { formula("193e6*(1 + eps)"); }, "here: hardening \"193e6*(1 + eps)\"");
  expect_invalid([] { formula("2*("); }, "here: hardening");
  expect_invalid([] { formula("-1 - ep"); }, "here: yield stress at ep = 0 = -1, expected finite > 0");
  expect_invalid([] { formula("1/ep"); }, "ep = 0");
  expect_invalid([] { formula("1 + log(ep)"); }, "ep = 0");
  expect_invalid([] { formula("1 - ep^0.3"); }, "here: slope of the yield stress = -3162.28 at ep = 0");
  expect_invalid([] { formula("2 - 3*ep"); },
                 "here: slope of the yield stress = -3 at ep = 0, expected >= 0: with");
  expect_invalid([] { formula("2 + sin(8*ep)"); }, "softening=true runs it all the same");
}

TEST(FormulaHardening, WithoutAValueItIsNotFinite) {
  const auto falling = formula("2 - 3*ep", true);
  EXPECT_EQ(falling->at(0.5).value, 0.5);
  EXPECT_TRUE(std::isnan(falling->at(0.7).value));
  EXPECT_TRUE(std::isnan(falling->at(std::nan("")).value));
  EXPECT_TRUE(std::isnan(local_solve(*falling, 0, 10, 2, 0.1))) << "stiffness + H' < 0";
  EXPECT_TRUE(std::isnan(local_solve(*falling, 0, 10, 4, 0.1))) << "no yield stress left";
  EXPECT_NEAR(local_solve(*falling, 0, 2.2, 4, 0.1), 0.2, 1e-15);
}

TEST(TabulatedHardening, StraightBetweenConstantBehind) {
  const auto law = table({0, 0.05, 0.2}, {193e6, 240e6, 300e6});
  EXPECT_EQ(law->at(0).value, 193e6);
  EXPECT_NEAR(law->at(0.025).value, 216.5e6, 1e-6);
  EXPECT_NEAR(law->at(0.025).slope, 47e6 / 0.05, 1e-4);
  EXPECT_EQ(law->at(0.05).value, 240e6);
  EXPECT_NEAR(law->at(0.05).slope, 60e6 / 0.15, 1e-4) << "behind the entry";
  EXPECT_NEAR(law->at(0.1).value, 260e6, 1e-6);
  for (double ep : {0.2, 0.3, 100.}) {
    EXPECT_EQ(law->at(ep).value, 300e6);
    EXPECT_EQ(law->at(ep).slope, 0);
  }
  EXPECT_EQ(table({0}, {5})->at(2).value, 5) << "one entry: perfect";
  for (double excess : {1e-3, 0.2, 1., 5.}) { // over several corners in one return
    const double q = 193e6 * (1 + excess), x = local_solve(*law, 0, q, 1e9, excess);
    EXPECT_NEAR(q - 1e9 * x, law->at(x).value, 1e-13 * q);
  }
}

TEST(TabulatedHardening, Errors) {
  const double NOT_A_NUMBER = std::nan("");
  expect_invalid([] { table({}, {}); }, "here: entries of plasticstrain = 0, expected at least 1");
  expect_invalid(
      [] {
        table({0, 1}, {5});
      },
      "here: entries of yieldstress = 1, expected as many as of plasticstrain, 2");
  expect_invalid([] { table({0.1, 1}, {5, 6}); }, "here: plasticstrain[0] = 0.1, expected 0");
  expect_invalid(
      [] {
        table({0, 0.2, 0.2}, {5, 6, 7});
      },
      "here: plasticstrain[2] = 0.2, expected finite and larger");
  expect_invalid([&] { table({0, NOT_A_NUMBER}, {5, 6}); }, "here: plasticstrain[1] = nan");
  expect_invalid([] { table({0, 1}, {5, 0}); }, "here: yieldstress[1] = 0, expected finite > 0");
  expect_invalid([&] { table({0, 1}, {NOT_A_NUMBER, 7}); }, "here: yieldstress[0] = nan");
  expect_invalid(
      [] {
        table({0, 0.1, 0.2}, {5, 6, 4});
      },
      "here: yieldstress[2] = 4, expected >= the entry before: with");
  EXPECT_NEAR(table({0, 0.1, 0.2}, {5, 6, 4}, true)->at(0.15).value, 5, 1e-14);
}

TEST(HardeningInput, NamesFormulasAndTables) {
  EXPECT_NO_THROW(law({{{"sigY", 1e8}, {"H", 0}}}));
  EXPECT_NO_THROW(law({{{"sigY", 1e8}}, "perfect"}));
  EXPECT_NO_THROW(law({{}, "1e8 + 1e9*ep"}));
  EXPECT_NO_THROW(law({{}, "", {0, 1}, {1e8, 2e8}}));
  expect_invalid(
      [] {
        law({{}, "power"});
      },
      "here: unknown hardening \"power\", expected one of linear, perfect, or a");
  expect_invalid(
      [] {
        law({{{"sigY", 1e8}}, "1e8 + ep"});
      },
      "here: parameter sigY is none of hardening by a formula");
  expect_invalid(
      [] {
        law({{{"sigY", 1e8}, {"H", 1}}, "perfect"});
      },
      "parameter H is none of hardening \"perfect\", sigY");
  expect_invalid(
      [] {
        law({{{"H", 1}}, "", {0, 1}, {1e8, 2e8}});
      },
      "parameter H is none of hardening by a table");
  expect_invalid([] { law({{}, "perfect", {0, 1}, {1e8, 2e8}}); }, "give either hardening or plasticstrain");
  expect_invalid(
      [] {
        law({{{"sigY", 1e8}, {"H", -1e9}}});
      },
      "here: slope of the yield stress = -1e+09 at ep = 0");
  LawInput steep{{{"sigY", 1e8}, {"H", -1e12}}};
  steep.softening = true;
  expect_invalid([&] { law(steep); }, "here: slope of the yield stress at ep = 0 = -1e+12, expected > -3G");
}

TEST(HardeningInput, BackstressAndRate) {
  const LawNumbers numbers = {{"sigY", 1e8}, {"H", 0}, {"C", 1e9}, {"gamma", 10}};
  const auto make = [](LawNumbers given, const std::string& backstress) {
    LawInput input{std::move(given)};
    input.backstress = backstress;
    return law(input);
  };
  EXPECT_EQ(make(numbers, "armstrongfrederick")->internal_variables().names(),
            "plastic_strain_eq, backstress");
  EXPECT_EQ(make(numbers, "armstrongfrederick")->internal_variables().size(), 5);
  expect_invalid([&] { make(numbers, "prager"); },
                 "parameter gamma is none of hardening \"linear\", sigY + H*ep, nor of "
                 "backstress \"prager\"");
  expect_invalid([&] { make(numbers, "none"); }, "here: parameter C is none of");
  expect_invalid([&] { make(numbers, "chaboche"); },
                 "here: unknown backstress \"chaboche\", expected one of none, prager, armstrongfrederick");
  LawNumbers few = numbers;
  few.erase("gamma");
  expect_invalid([&] { make(few, "armstrongfrederick"); }, "here: parameter gamma is missing (recovery");
  few["C"] = 0;
  expect_invalid([&] { make(few, "prager"); }, "here: C = 0, expected finite > 0");
  few["C"] = 1;
  few["gamma"] = -1;
  expect_invalid([&] { make(few, "armstrongfrederick"); }, "here: gamma = -1, expected finite >= 0");
  LawInput input{{{"sigY", 1e8}, {"H", 0}}};
  input.rate = "oldroyd";
  expect_invalid([&] { law(input); }, "here: unknown rate \"oldroyd\"");
}

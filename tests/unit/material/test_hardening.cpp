// Hardening laws: the table, its errors, and the local solve for laws that are not linear.
#include "material/hardening.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>
#include <limits>
#include <set>

using namespace burnish;
using burnish::test::expect_invalid;

namespace {

/// sigma_y = sigma_0 + Q (1 - exp(-b ep)): steep at first, flat later.
class Saturating final : public HardeningLaw {
public:
  YieldStress evaluate(double plastic_strain_eq) const override {
    const double rest = std::exp(-40 * plastic_strain_eq);
    return {2e8 + 3e8 * (1 - rest), 3e8 * 40 * rest};
  }
};

/// sigma_y = sigma_0 (1 + ep/a)^n with an infinite slope just before the start: Newton's first step overshoots.
class Power final : public HardeningLaw {
public:
  YieldStress evaluate(double plastic_strain_eq) const override {
    const double base = 1 + plastic_strain_eq / 1e-9;
    return {1e6 * std::pow(base, 0.3), 1e6 * 0.3 * std::pow(base, -0.7) / 1e-9};
  }
};

} // namespace

TEST(Hardening, LinearIsTheWrittenFormula) {
  const auto law = linear_hardening(1.93e8, 9.62e8);
  EXPECT_TRUE(law->is_linear());
  for (double plastic_strain_eq : {0., 0.1, 3.}) {
    EXPECT_EQ(law->at(plastic_strain_eq).value, 1.93e8 + 9.62e8 * plastic_strain_eq);
    EXPECT_EQ(law->at(plastic_strain_eq).slope, 9.62e8);
  }
  EXPECT_EQ(linear_hardening(2, 0)->at(7).value, 2) << "perfect plasticity";
}

TEST(Hardening, LinearIncrementIsClosedForm) {
  const auto law = linear_hardening(1.93e8, 9.62e8);
  const YieldStress yield = law->at(0.1);
  EXPECT_EQ(plastic_increment(*law, yield, 0.1, 4e8, 8.1e10), (4e8 - yield.value) / (8.1e10 + 9.62e8));
}

TEST(Hardening, AnyLawIsSolvedToRounding) {
  const Saturating saturating;
  const Power power;
  for (const HardeningLaw* law :
       {static_cast<const HardeningLaw*>(&saturating), static_cast<const HardeningLaw*>(&power)})
    for (double start : {0., 1e-3, 0.2})
      for (double stiffness : {8.1e10, 1e9})
        for (double excess : {0., 1e-12, 1e-3, 1., 300.}) {
          const YieldStress yield = law->at(start);
          const double q = yield.value * (1 + excess);
          const double x = plastic_increment(*law, yield, start, q, stiffness);
          EXPECT_GE(x, 0);
          EXPECT_NEAR((q - stiffness * x - law->at(start + x).value) / q, 0, 2e-14)
              << "start " << start << ", excess " << excess;
        }
}

TEST(Hardening, SlopesAgainstFiniteDifferences) { // of all laws of the table, with parameters of usual size
  for (const HardeningEntry& entry : hardening_laws()) {
    std::vector<double> values;
    for (const LawParameter& parameter : entry.parameters)
      values.push_back(std::string(parameter.unit) == "stress" ? 2e8 : 0.3);
    const auto law = entry.make(values);
    for (double plastic_strain_eq : {0.01, 0.1, 1.}) {
      const auto value = [&](double t) { return law->at(plastic_strain_eq + t).value; };
      const double slope = law->at(plastic_strain_eq).slope;
      EXPECT_NEAR(test::finite_difference(value, 0, 1e-4), slope, 1e-8 * (slope + 2e8)) << entry.name;
    }
  }
}

TEST(Hardening, TableIsComplete) {
  std::set<std::string> names;
  for (const HardeningEntry& entry : hardening_laws()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " occurs twice";
    EXPECT_NE(std::string(entry.formula), "");
    for (const LawParameter& parameter : entry.parameters) {
      EXPECT_NE(std::string(entry.formula).find(parameter.name), std::string::npos) << parameter.name;
      EXPECT_FALSE(parameter.allowed(std::nan(""))) << parameter.name;
      EXPECT_FALSE(parameter.allowed(std::numeric_limits<double>::infinity())) << parameter.name;
      for (const char* text : {parameter.meaning, parameter.unit, parameter.expected})
        EXPECT_NE(std::string(text), "") << parameter.name;
    }
  }
  EXPECT_EQ(names.count("linear"), 1u);
}

TEST(Hardening, Errors) {
  const auto make = [](const std::string& name, const LawNumbers& numbers) {
    make_hardening(name, numbers, "here");
  };
  expect_invalid([&] { make("none", {}); },
                 "here: unknown hardening \"none\", expected one of linear, perfect");
  expect_invalid(
      [&] {
        make("linear", {{"H", 1}});
      },
      "here: parameter sigY is missing (initial yield stress, finite > 0)");
  expect_invalid([&] { make("linear", {{"sigY", 1}}); }, "here: parameter H is missing");
  expect_invalid([&] { make("linear", {{"sigY", 0}, {"H", 1}}); }, "here: sigY = 0, expected finite > 0");
  expect_invalid(
      [&] {
        make("linear", {{"sigY", 1}, {"H", -3}});
      },
      "here: slope of the yield stress = -3 at ep = 0, expected >= 0: with softening");
  expect_invalid([] { linear_hardening(1, std::numeric_limits<double>::infinity()); },
                 "linear_hardening: H = inf, expected finite");
  expect_invalid([] { linear_hardening(std::nan(""), 0); }, "linear_hardening: sigY = nan");
}

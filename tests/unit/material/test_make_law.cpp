#include "material/j2/law.hpp"
#include "material/make_law.hpp"
#include "unit/finite_difference.hpp"
#include <set>

using namespace burnish;
using burnish::test::expect_invalid;

namespace {
const LawNumbers STEEL = {{"E", 2.1e11}, {"nu", 0.3}, {"sigY", 2e8}, {"H", 1e9}};

LawNumbers with(LawNumbers numbers, const std::string& name, double value) {
  numbers[name] = value;
  return numbers;
}
LawNumbers without(LawNumbers numbers, const std::string& name) {
  numbers.erase(name);
  return numbers;
}
} // namespace

TEST(MakeLaw, J2FromNumbers) {
  const auto law = make_law<2>({STEEL}, "here");
  EXPECT_EQ(law->name(), "J2");
  EXPECT_EQ(law->internal_variables().names(), "plastic_strain_eq");
  const auto& parameters = dynamic_cast<const J2Law<2>&>(*law).parameters();
  const auto by_hand = J2Parameters::from_young(2.1e11, 0.3, 2e8, 1e9);
  EXPECT_EQ(parameters.elastic.K, by_hand.elastic.K);
  EXPECT_EQ(parameters.elastic.G, by_hand.elastic.G);
  EXPECT_EQ(parameters.yield_stress(0.3).value, 2e8 + 0.3 * 1e9);
}

TEST(MakeLaw, ParametersOfAllLaws) {
  std::set<std::string> names;
  for (const LawParameter& parameter : law_parameters()) EXPECT_TRUE(names.insert(parameter.name).second);
  for (const char* name : {"G", "E", "nu", "sigY", "H", "C", "gamma"})
    EXPECT_EQ(names.count(name), 1u) << name;
  for (const HardeningEntry& entry : hardening_laws())
    for (const LawParameter& parameter : entry.parameters) EXPECT_EQ(names.count(parameter.name), 1u);
}

TEST(MakeLaw, Errors) {
  const auto make = [](const LawNumbers& numbers) { make_law<2>({numbers}, "here"); };
  for (const char* name : {"nu", "sigY", "H"})
    expect_invalid([&] { make(without(STEEL, name)); },
                   std::string("here: parameter ") + name + " is missing");
  expect_invalid([&] { make(without(STEEL, "E")); }, "here: give exactly one of G");
  expect_invalid([&] { make(with(STEEL, "G", 1)); }, "here: give exactly one of G");
  expect_invalid([&] { make(with(STEEL, "nu", 0.5)); }, "here: nu = 0.5, expected -1 < nu < 0.5");
  expect_invalid([&] { make(with(STEEL, "H", -1)); },
                 "here: slope of the yield stress = -1 at ep = 0, expected >= 0");
  expect_invalid([&] { make(with(STEEL, "Q", 1)); },
                 "here: parameter Q is none of hardening \"linear\", sigY + H*ep");
  expect_invalid(
      [] {
        make_law<2>({STEEL, "power"}, "here");
      },
      "here: unknown hardening \"power\", expected one of linear");
}

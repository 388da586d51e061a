#include "material/j2.hpp"
#include "material/update_options.hpp"
#include "unit/finite_difference.hpp"
#include <limits>

using namespace burnish;
using burnish::test::expect_invalid;

namespace {
const double INFINITE = std::numeric_limits<double>::infinity(), NOT_A_NUMBER = std::nan("");
}

TEST(J2Parameters, ModuliFromShearAndFromYoung) {
  const double G = 2.7e10, nu = 0.32, E = 2 * G * (1 + nu);
  const J2Parameters shear = J2Parameters::from_shear(G, nu, 1.93e8, 9.62e8);
  const J2Parameters young = J2Parameters::from_young(E, nu, 1.93e8, 9.62e8);
  EXPECT_NEAR(shear.K, E / (3 * (1 - 2 * nu)), 1e-14 * shear.K);
  EXPECT_NEAR(young.K, shear.K, 1e-14 * shear.K);
  EXPECT_NEAR(young.G, G, 1e-14 * G);
  EXPECT_EQ(shear.yield_stress, 1.93e8);
  EXPECT_EQ(young.hardening_modulus, 9.62e8);
  EXPECT_NEAR(yield_stress_at(shear, 0.1), 1.93e8 + 9.62e7, 1e-7);
}

TEST(J2Parameters, PerfectPlasticityIsAllowed) {
  EXPECT_EQ(J2Parameters::from_young(2, 0.3, 1, 0).hardening_modulus, 0);
}

TEST(J2Parameters, Errors) {
  const auto shear = J2Parameters::from_shear, young = J2Parameters::from_young;
  expect_invalid([&] { shear(-1, 0.3, 1, 1); }, "J2Parameters::from_shear: G = -1, expected finite > 0");
  expect_invalid([&] { shear(INFINITE, 0.3, 1, 1); }, "J2Parameters::from_shear: G = inf");
  expect_invalid([&] { young(0, 0.3, 1, 1); }, "J2Parameters::from_young: E = 0, expected finite > 0");
  expect_invalid([&] { shear(1, 0.5, 1, 1); }, "J2Parameters::from_shear: nu = 0.5, expected -1 < nu < 0.5");
  expect_invalid([&] { young(1, -1, 1, 1); }, "J2Parameters::from_young: nu = -1, expected -1 < nu < 0.5");
  expect_invalid([&] { young(1, NOT_A_NUMBER, 1, 1); }, "J2Parameters::from_young: nu = nan");
  expect_invalid([&] { shear(1, 0.3, 0, 1); }, "yield_stress = 0, expected finite > 0");
  expect_invalid([&] { shear(1, 0.3, 1, -1); }, "hardening_modulus = -1, expected finite >= 0");
  expect_invalid([&] { shear(1, 0.3, 1, INFINITE); }, "hardening_modulus = inf");
  J2Parameters by_hand{0, 1, 1, 1};
  expect_invalid([&] { require_valid(by_hand, "here"); }, "here: K = 0, expected finite > 0");
}

TEST(UpdateOptions, DefaultsAndInfiniteLimitAreValid) {
  UpdateOptions options;
  EXPECT_NO_THROW(require_valid(options, "here"));
  options.path_limit = INFINITE;
  EXPECT_NO_THROW(require_valid(options, "here"));
}

TEST(UpdateOptions, Errors) {
  const auto with = [](auto change, const std::string& text) {
    UpdateOptions options;
    change(options);
    expect_invalid([&] { require_valid(options, "here"); }, text);
  };
  with([](UpdateOptions& o) { o.path_limit = -1; }, "here: path_limit = -1, expected >= 0");
  with([](UpdateOptions& o) { o.path_limit = NOT_A_NUMBER; }, "here: path_limit = nan");
  with([](UpdateOptions& o) { o.min_substeps = 0; }, "here: min_substeps = 0, expected >= 1");
  with([](UpdateOptions& o) { o.max_substeps = 2; }, "here: max_substeps = 2, expected >= min_substeps");
  with([](UpdateOptions& o) { o.substep_strain = 0; }, "here: substep_strain = 0, expected > 0");
  with([](UpdateOptions& o) { o.freeze_iteration = 0; }, "here: freeze_iteration = 0, expected >= 1");
}

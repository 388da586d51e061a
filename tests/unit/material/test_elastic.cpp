#include "material/elastic.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>
#include <limits>

using namespace burnish;
using burnish::test::expect_invalid;

namespace {
const double INFINITE = std::numeric_limits<double>::infinity(), NOT_A_NUMBER = std::nan("");
}

TEST(ElasticModuli, FromShearAndFromYoung) {
  const double G = 2.7e10, nu = 0.32, E = 2 * G * (1 + nu);
  const ElasticModuli shear = ElasticModuli::from_shear(G, nu), young = ElasticModuli::from_young(E, nu);
  EXPECT_NEAR(shear.K, E / (3 * (1 - 2 * nu)), 1e-14 * shear.K);
  EXPECT_NEAR(young.K, shear.K, 1e-14 * shear.K);
  EXPECT_NEAR(young.G, G, 1e-14 * G);
  const ElasticModuli named = ElasticModuli::from_numbers({{"E", E}, {"nu", nu}, {"other", -1}}, "here");
  EXPECT_EQ(named.K, young.K);
  EXPECT_EQ(named.G, young.G);
}

TEST(ElasticModuli, Errors) {
  const auto shear = [](double G, double nu) { ElasticModuli::from_shear(G, nu); };
  const auto young = [](double E, double nu) { ElasticModuli::from_young(E, nu); };
  expect_invalid([&] { shear(-1, 0.3); }, "ElasticModuli::from_shear: G = -1, expected finite > 0");
  expect_invalid([&] { shear(INFINITE, 0.3); }, "ElasticModuli::from_shear: G = inf");
  expect_invalid([&] { young(0, 0.3); }, "ElasticModuli::from_young: E = 0, expected finite > 0");
  expect_invalid([&] { shear(1, 0.5); }, "ElasticModuli::from_shear: nu = 0.5, expected -1 < nu < 0.5");
  expect_invalid([&] { young(1, -1); }, "ElasticModuli::from_young: nu = -1, expected -1 < nu < 0.5");
  expect_invalid([&] { young(1, NOT_A_NUMBER); }, "ElasticModuli::from_young: nu = nan");
  const auto numbers = [](const LawNumbers& given) { ElasticModuli::from_numbers(given, "here"); };
  expect_invalid(
      [&] {
        numbers({{"nu", 0.3}});
      },
      "here: give exactly one of G (shear modulus) and E (Young's");
  expect_invalid([&] { numbers({{"G", 1}, {"E", 1}, {"nu", 0.3}}); }, "here: give exactly one of G");
  expect_invalid(
      [&] {
        numbers({{"G", 1}});
      },
      "here: parameter nu is missing (Poisson's ratio, -1 < nu < 0.5)");
  expect_invalid([] { require_valid(ElasticModuli{0, 1}, "here"); }, "here: K = 0, expected finite > 0");
  expect_invalid([] { require_valid(ElasticModuli{1, NOT_A_NUMBER}, "here"); }, "here: G = nan");
}

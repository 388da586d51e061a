#include "material/elastic.hpp"
#include "base/error.hpp"

namespace burnish {

const std::vector<LawParameter>& elastic_parameters() {
  static const std::vector<LawParameter> table = {
      {"G", "shear modulus", "stress", positive, "finite > 0"},
      {"E", "Young's modulus", "stress", positive, "finite > 0"},
      {"nu", "Poisson's ratio", "-", [](double nu) { return nu > -1 && nu < 0.5; }, "-1 < nu < 0.5"}};
  return table;
}

void require_valid(const ElasticModuli& elastic, const char* where) {
  require(positive(elastic.K), where, "K", elastic.K, "finite > 0");
  require(positive(elastic.G), where, "G", elastic.G, "finite > 0");
}

ElasticModuli ElasticModuli::from_shear(double G, double nu, const char* where) {
  return from_numbers({{"G", G}, {"nu", nu}}, where);
}

ElasticModuli ElasticModuli::from_young(double E, double nu, const char* where) {
  return from_numbers({{"E", E}, {"nu", nu}}, where);
}

ElasticModuli ElasticModuli::from_numbers(const LawNumbers& numbers, const char* where) {
  if (numbers.count("G") == numbers.count("E"))
    fail(where, "give exactly one of G (shear modulus) and E (Young's modulus)");
  const bool shear = numbers.count("G") > 0;
  const double modulus = number_of(numbers, parameter_named(elastic_parameters(), shear ? "G" : "E"), where);
  const double nu = number_of(numbers, parameter_named(elastic_parameters(), "nu"), where);
  ElasticModuli elastic;
  elastic.G = shear ? modulus : modulus / (2 * (1 + nu));
  elastic.K = 2 * elastic.G * (1 + nu) / (3 * (1 - 2 * nu));
  require_valid(elastic, where);
  return elastic;
}

} // namespace burnish

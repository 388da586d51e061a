#include "material/make_law.hpp"
#include "base/error.hpp"
#include "material/j2/law.hpp"
#include <algorithm>

namespace burnish {
namespace {

bool has(const std::vector<LawParameter>& table, const std::string& name) {
  return std::any_of(table.begin(), table.end(), [&](const LawParameter& p) { return p.name == name; });
}

// What the law does not read is a mistake of the script.
void refuse_strangers(const LawInput& input, const char* where) {
  for (const HardeningEntry& entry : hardening_laws())
    for (const auto& [name, value] : input.numbers)
      if (entry.name == input.hardening && !has(elastic_parameters(), name) && !has(entry.parameters, name))
        fail(where, "parameter " + name + " is none of hardening \"" + entry.name + "\", " + entry.formula);
}

} // namespace

const std::vector<LawParameter>& law_parameters() {
  static const std::vector<LawParameter> all = [] {
    std::vector<LawParameter> list = elastic_parameters();
    for (const HardeningEntry& entry : hardening_laws())
      for (const LawParameter& parameter : entry.parameters)
        if (!has(list, parameter.name)) list.push_back(parameter);
    return list;
  }();
  return all;
}

template <int Dim>
std::shared_ptr<const MaterialLaw<Dim>> make_law(const LawInput& input, const char* where) {
  J2Parameters material;
  material.elastic = ElasticModuli::from_numbers(input.numbers, where);
  material.hardening = make_hardening(input.hardening, input.numbers, where);
  refuse_strangers(input, where);
  return j2_law<Dim>(std::move(material));
}

template std::shared_ptr<const MaterialLaw<2>> make_law<2>(const LawInput&, const char*);

} // namespace burnish

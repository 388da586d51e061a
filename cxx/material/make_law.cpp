#include "material/make_law.hpp"
#include "base/error.hpp"
#include "material/formula_hardening.hpp"
#include "material/j2/law.hpp"
#include "material/tabulated_hardening.hpp"
#include <algorithm>
#include <cctype>

namespace burnish {
namespace {

bool has(const std::vector<LawParameter>& table, const std::string& name) {
  return std::any_of(table.begin(), table.end(), [&](const LawParameter& p) { return p.name == name; });
}

using Parameters = std::vector<LawParameter>;

/// A choice among laws: what it is called in messages, and the parameters it reads.
struct Choice {
  std::string text;
  Parameters parameters;
};

// What the law does not read is a mistake of the script.
void refuse_strangers(const LawNumbers& numbers, const Choice& hardening, const Choice& backstress,
                      const char* where) {
  for (const auto& [name, value] : numbers)
    if (!has(elastic_parameters(), name) && !has(hardening.parameters, name) &&
        !has(backstress.parameters, name))
      fail(where, "parameter " + name + " is none of " + hardening.text + ", nor of " + backstress.text);
}

// A single word is a name, anything else a formula.
bool is_word(const std::string& text) {
  return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

std::shared_ptr<const HardeningLaw> chosen_hardening(const LawInput& input, Choice& choice,
                                                     const char* where) {
  if (!input.plastic_strain.empty() || !input.yield_stress.empty()) {
    if (!input.hardening.empty())
      fail(where, "give either hardening or plasticstrain and yieldstress, hardening is \"" +
                      input.hardening + "\"");
    choice.text = "hardening by a table";
    return tabulated_hardening(input.plastic_strain, input.yield_stress, input.softening, where);
  }
  const std::string name = input.hardening.empty() ? "linear" : input.hardening;
  for (const HardeningEntry& entry : hardening_laws())
    if (entry.name == name) {
      choice = {"hardening \"" + name + "\", " + entry.formula, entry.parameters};
      return make_hardening(name, input.numbers, where, input.softening);
    }
  if (is_word(name) && name != "ep")
    fail(where,
         "unknown hardening \"" + name + "\", expected one of " + hardening_names() + ", or a formula in ep");
  choice.text = "hardening by a formula";
  return formula_hardening(name, input.softening, where);
}

} // namespace

const std::vector<LawParameter>& law_parameters() {
  static const std::vector<LawParameter> all = [] {
    Parameters list = elastic_parameters();
    const auto add = [&](const Parameters& parameters) {
      for (const LawParameter& parameter : parameters)
        if (!has(list, parameter.name)) list.push_back(parameter);
    };
    for (const HardeningEntry& entry : hardening_laws()) add(entry.parameters);
    for (const BackstressEntry& entry : backstress_laws()) add(entry.parameters);
    return list;
  }();
  return all;
}

template <int Dim>
std::shared_ptr<const MaterialLaw<Dim>> make_law(const LawInput& input, const char* where) {
  J2Parameters material;
  material.elastic = ElasticModuli::from_numbers(input.numbers, where);
  Choice hardening;
  material.hardening = chosen_hardening(input, hardening, where);
  const BackstressEntry& backstress = backstress_law(input.backstress, where);
  material.kinematic = make_kinematic_hardening(backstress, input.numbers, where);
  material.rate = corotational_rate(input.rate, where);
  if (input.small_strain && material.rate != CorotationalRate::JAUMANN)
    fail(where,
         "rate=\"" + input.rate + "\" with strain=\"small\", in which nothing turns, expected one of them");
  if (input.small_strain) material.rate = CorotationalRate::SMALL_STRAIN;
  refuse_strangers(
      input.numbers, hardening,
      {std::string("backstress \"") + backstress.name + "\", " + backstress.formula, backstress.parameters},
      where);
  require_valid(material, where);
  return j2_law<Dim>(std::move(material));
}

template std::shared_ptr<const MaterialLaw<2>> make_law<2>(const LawInput&, const char*);
template std::shared_ptr<const MaterialLaw<3>> make_law<3>(const LawInput&, const char*);

} // namespace burnish

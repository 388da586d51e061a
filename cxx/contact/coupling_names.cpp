// Relations between coordinates as text: names with a dot become names that the formula engine reads.
#include "base/error.hpp"
#include "contact/coupling.hpp"
#include "kinematics/coordinates.hpp"
#include <algorithm>
#include <cctype>

namespace burnish {
namespace {

bool of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Identifiers of the same length where that is possible, so that places in messages stay right.
std::vector<std::string> identifiers(const std::vector<std::string>& dotted) {
  std::vector<std::string> result;
  for (std::string name : dotted) {
    for (char& c : name)
      if (!of_name(c)) c = '_';
    if (!std::isalpha(static_cast<unsigned char>(name[0]))) name.insert(0, "t");
    while (std::find(result.begin(), result.end(), name) != result.end()) name += "_";
    result.push_back(name);
  }
  return result;
}

// Length of the longest dotted name that begins at a place of the text, and which one it is; 0 if there is none.
std::pair<std::size_t, std::size_t> name_at(const std::string& text, std::size_t place,
                                            const std::vector<std::string>& dotted) {
  std::pair<std::size_t, std::size_t> best{0, 0};
  if (place > 0 && (of_name(text[place - 1]) || text[place - 1] == '.')) return best;
  for (std::size_t k = 0; k < dotted.size(); ++k) {
    const std::size_t length = dotted[k].size();
    if (length <= best.first || text.compare(place, length, dotted[k]) != 0) continue;
    if (place + length < text.size() && of_name(text[place + length])) continue;
    best = {length, k};
  }
  return best;
}

// A name with a dot that no tool has: "upper.z"; empty if there is none.
std::string unknown_name(const std::string& text) {
  for (std::size_t dot = 1; dot + 1 < text.size(); ++dot) {
    if (text[dot] != '.' || !of_name(text[dot - 1]) ||
        !std::isalpha(static_cast<unsigned char>(text[dot + 1])))
      continue;
    std::size_t first = dot, last = dot + 1;
    while (first > 0 && of_name(text[first - 1])) --first;
    while (last < text.size() && of_name(text[last])) ++last;
    if (!std::isdigit(static_cast<unsigned char>(text[first]))) return text.substr(first, last - first);
  }
  return "";
}

std::string translated(const std::string& text, const std::vector<std::string>& dotted,
                       const std::vector<std::string>& names) {
  std::string result;
  for (std::size_t place = 0; place < text.size();) {
    const auto [length, k] = name_at(text, place, dotted);
    result += length ? names[k] : std::string(1, text[place]);
    place += std::max<std::size_t>(length, 1);
  }
  return result;
}

// What is followed must be independent, and what follows must be followed by nothing.
template <int Dim>
void check_independent(const ContactModel<Dim>& model, const Coupling& made,
                       const std::vector<std::string>& dotted, const std::string& text) {
  const char* where = "contact.couple";
  const std::string& dependent = dotted[static_cast<std::size_t>(made.dependent)];
  for (const int k : made.formula->arguments()) {
    const std::string& argument = dotted[static_cast<std::size_t>(k)];
    if (k == made.dependent) fail(where, "\"" + dependent + "\" = \"" + text + "\" follows itself");
    if (model.coupling_of(k))
      fail(where, "\"" + dependent + "\" = \"" + text + "\" follows \"" + argument +
                      "\", which follows others itself; relations must name independent coordinates");
  }
  for (const Coupling& other : model.couplings) {
    const std::vector<int>& arguments = other.formula->arguments();
    if (std::find(arguments.begin(), arguments.end(), made.dependent) != arguments.end())
      fail(where, "\"" + dotted[static_cast<std::size_t>(other.dependent)] + "\" follows \"" + dependent +
                      "\", which cannot follow \"" + text +
                      "\" then; relations must name independent coordinates");
  }
}

} // namespace

template <int Dim> std::vector<std::string> dotted_names(const ContactModel<Dim>& model) {
  std::vector<std::string> names;
  for (const auto& tool : model.tools)
    for (const std::string& coordinate : tool->coordinates().names())
      names.push_back(tool->name() + "." + coordinate);
  return names;
}

template <int Dim>
Coupling make_coupling(const ContactModel<Dim>& model, const std::string& dependent,
                       const std::string& text) {
  const char* where = "contact.couple";
  const std::vector<std::string> dotted = dotted_names(model), names = identifiers(dotted);
  const auto known = std::find(dotted.begin(), dotted.end(), dependent);
  if (known == dotted.end())
    fail(where,
         "unknown coordinate \"" + dependent + "\", expected tool.coordinate, one of " + joined(dotted));
  const std::string formula = translated(text, dotted, names), unknown = unknown_name(formula);
  if (!unknown.empty())
    fail(where,
         "unknown coordinate \"" + unknown + "\" in \"" + text + "\", expected one of " + joined(dotted));
  Coupling made{static_cast<int>(known - dotted.begin()),
                std::make_shared<CoordinateFormula>("contact.couple: relation of \"" + dependent + "\"",
                                                    formula, FormulaNames{names, {}}, true)};
  if (made.formula->arguments().empty())
    fail(where,
         "\"" + dependent + "\" = \"" + text + "\" depends on no coordinate; prescribe its motion instead");
  check_independent(model, made, dotted, text);
  return made;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template std::vector<std::string> dotted_names<Dim>(const ContactModel<Dim>&);                             \
  template Coupling make_coupling<Dim>(const ContactModel<Dim>&, const std::string&, const std::string&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish

#include "material/unit_warnings.hpp"
#include <cmath>
#include <sstream>

namespace burnish {

namespace {

constexpr double LEAST_YIELD = 1e-6, MOST_HARDENING = 1; // over Young's modulus
constexpr double MOST_STRAIN = 8; // at the end of a table of the yield stress: known ones end below

constexpr double ELASTIC = 1e30, ROUND = 1e-9, MOST_MULTIPLE = 1e6;

/// Whether it is 1, 10, 100, ... or 0.1, 0.01, ...
bool power_of_ten(double value) {
  const double exponent = std::log10(value);
  return std::abs(exponent - std::round(exponent)) < ROUND;
}

bool round_multiple(double ratio) { return ratio <= MOST_MULTIPLE * (1 + ROUND) && power_of_ten(ratio); }

/// Whether a yield stress above Young's modulus says that the workpiece is elastic: 1e30, or a round number, or a round multiple of a modulus.
bool elastic_on_purpose(double sigY, double E, double G) {
  return sigY >= ELASTIC || power_of_ten(sigY) || round_multiple(sigY / E) ||
         (G > 0 && round_multiple(sigY / G));
}

double number(const LawNumbers& numbers, const char* name) {
  const auto found = numbers.find(name);
  return found == numbers.end() ? 0 : found->second;
}

std::string line(const char* where, const char* name, double value, double E, const char* known) {
  std::ostringstream text;
  text << where << ": " << name << " = " << value << " is " << value / E << " of E = " << E
       << ", known materials have " << known << ": are the units mixed?\n";
  return text.str();
}

} // namespace

std::string unit_warnings(const LawNumbers& numbers, const char* where,
                          const std::vector<double>& plastic_strain) {
  double E = number(numbers, "E");
  const double G = E > 0 ? E / (2 * (1 + number(numbers, "nu"))) : number(numbers, "G");
  if (E == 0) E = 2 * G * (1 + number(numbers, "nu"));
  const double sigY = number(numbers, "sigY"), H = number(numbers, "H");
  std::string text;
  if (!plastic_strain.empty() && plastic_strain.back() > MOST_STRAIN) {
    std::ostringstream table;
    table << where << ": plasticstrain ends at " << plastic_strain.back() << ", that is "
          << 100 * plastic_strain.back() << " %, known tables end below " << MOST_STRAIN
          << ": is it in per cent?\n";
    text += table.str();
  }
  if (!(E > 0)) return text;
  if (sigY > 0 && sigY < LEAST_YIELD * E) text += line(where, "sigY", sigY, E, "more than 1e-6");
  if (sigY > E && !elastic_on_purpose(sigY, E, G)) {
    std::ostringstream never;
    never << where << ": sigY = " << sigY << " is " << sigY / E << " of E = " << E
          << ", nothing will yield: is a digit or a unit another one? An elastic workpiece has sigY=1e30\n";
    text += never.str();
  }
  if (H > MOST_HARDENING * E) text += line(where, "H", H, E, "at most 1");
  return text;
}

} // namespace burnish

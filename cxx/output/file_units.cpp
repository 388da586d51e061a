#include "output/file_units.hpp"
#include <stdexcept>
#include <utility>
#include <vector>

namespace burnish {
namespace {

using KnownUnits = std::vector<std::pair<std::string, double>>;

double known_unit(const char* what, const std::string& unit, const KnownUnits& known) {
  std::string list;
  for (const auto& [name, value] : known) {
    if (name == unit) return value;
    list += (list.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument("rcUnits: unit of " + std::string(what) + " \"" + unit +
                              "\", expected one of " + list);
}

} // namespace

FileUnits file_units(const std::string& length, const std::string& stress) {
  return {length, stress, known_unit("length", length, {{"m", 1.}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}}),
          known_unit("stress", stress, {{"Pa", 1.}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}})};
}

} // namespace burnish

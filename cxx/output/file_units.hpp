#pragma once
// The units that a script says its numbers are in: no number is converted, files and pictures name them.
#include <string>

namespace burnish {

struct FileUnits {
  std::string length, stress; ///< "mm", "MPa"; both empty: not said
  double meters, pascals;     ///< one of them: 1e-3 m, 1e6 Pa
};

/// @param length  m, cm, mm or um  @param stress  Pa, kPa, MPa or GPa
/// @throws std::invalid_argument for any other word
FileUnits file_units(const std::string& length, const std::string& stress);

} // namespace burnish

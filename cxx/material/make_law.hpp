#pragma once
// The laws that Burnish ships, by the names and numbers that a script gives: the one place that knows them all.
#include "material/hardening.hpp"
#include "material/material_law.hpp"

namespace burnish {

struct LawInput {
  LawNumbers numbers;         ///< of the elastic moduli, the hardening law and the back stress, by name
  std::string hardening = {}; ///< entry of hardening_laws(), or a formula in ep; "": linear, or the table
  std::vector<double> plastic_strain = {},
                      yield_stress = {}; ///< table of the hardening [-, stress]; empty: none
  bool softening = false;                ///< the yield stress may fall
  std::string backstress = "none";       ///< entry of backstress_laws()
  std::string rate = "jaumann";          ///< see corotational_rate()
  bool small_strain = false;             ///< in place of a rate
};

/// Every number that some law reads, each name once, in the order of the tables.
const std::vector<LawParameter>& law_parameters();

/// J2 with isotropic and kinematic hardening.
/// @throws std::invalid_argument "where: ..." for an unknown hardening, backstress or rate, a number that is missing,
///         out of its range, or that no part of the chosen law reads, a wrong formula or table, both of them, and a
///         yield stress that falls without softening
template <int Dim> std::shared_ptr<const MaterialLaw<Dim>> make_law(const LawInput& input, const char* where);

} // namespace burnish

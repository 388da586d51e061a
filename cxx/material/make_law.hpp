#pragma once
// The laws that Burnish ships, by the names and numbers that a script gives: the one place that knows them all.
#include "material/hardening.hpp"
#include "material/material_law.hpp"

namespace burnish {

struct LawInput {
  LawNumbers numbers;               ///< of the elastic moduli and of the hardening law, by name
  std::string hardening = "linear"; ///< entry of hardening_laws()
};

/// Every number that some law reads, each name once, in the order of the tables.
const std::vector<LawParameter>& law_parameters();

/// J2 with isotropic hardening.
/// @throws std::invalid_argument "where: ..." for an unknown hardening, a number that is missing, out of its
/// range, or that
///         no part of the chosen law reads
template <int Dim> std::shared_ptr<const MaterialLaw<Dim>> make_law(const LawInput& input, const char* where);

} // namespace burnish

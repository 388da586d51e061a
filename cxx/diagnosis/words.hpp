#pragma once
// Failures in words.
#include "contact/contact_model.hpp"
#include "iteration/failure.hpp"

namespace burnish {

/// One failure. @param model gives the names of coordinates and tools
template <int Dim> std::string words(const Failure& failure, const ContactModel<Dim>& model);

/// Why a step failed: the first cause first, what was found in brackets behind it; without a cause what was found, with what
/// belongs to it.
/// @param found by the iteration, NONE: nothing; @param causes in the order of their rank; @param refusal of the caller, or ""
template <int Dim>
std::string words(const Failure& found, const std::vector<Failure>& causes, const std::string& refusal,
                  const ContactModel<Dim>& model);

} // namespace burnish

#pragma once
// How large an expression would become: asked before GiNaC computes something that never ends.
#include <ginac/ginac.h>

namespace burnish {

/// @throws std::invalid_argument if GiNaC would compute a power of numbers with more than 100 000 binary
/// digits: 2^(10^9), (2*x)^(10^9), 1.0000001^(10^6)
void require_moderate_power(const GiNaC::ex& base, const GiNaC::ex& exponent);

/// Estimate from above of the numbers, symbols and operations in the derivative, none of them shared.
double derivative_size(const GiNaC::ex& e, const GiNaC::ex& variable);

/// Estimate from above of the terms in e.expand().
double expanded_terms(const GiNaC::ex& e);

} // namespace burnish

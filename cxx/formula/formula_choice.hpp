#pragma once
// min, max and if of formulas as functions of GiNaC, which has none of them.
#include <ginac/ginac.h>

namespace burnish {

/// What GiNaC's parser knows beside its own functions: min(a, b); max(a, b); if(c, a, b), a where c > 0, else b; and
/// if_greater(l, r, a, b), if_less, if_least, if_most, which are a where l > r, l < r, l >= r, l <= r, else b.
/// Derivatives are exact: that of min and max where both are equal is the one on the side where the variable grows,
/// that of if is the one of the branch that is taken.
const GiNaC::prototype_table& choice_reader();

enum class Choice { NONE, MINIMUM, MAXIMUM, CONDITION };

/// Which of min, max, if the expression is; NONE: something else.
Choice choice_of(const GiNaC::ex& e);

} // namespace burnish

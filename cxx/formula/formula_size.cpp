#include "formula/formula_size.hpp"
#include "formula/formula_choice.hpp"
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace burnish {
namespace {

constexpr double LARGEST_POWER = 1e5; ///< binary digits

/// Binary digits of all numbers in the expression; 0, 1 and -1 count nothing.
double binary_digits(const GiNaC::ex& e) {
  double sum = 0;
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part) {
    if (!GiNaC::is_a<GiNaC::numeric>(*part)) continue;
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(*part);
    if (number.is_real() && !number.is_equal(1) && !number.is_equal(-1) && !number.is_zero())
      sum += number.numer().int_length() + number.denom().int_length();
  }
  return sum;
}

struct Sizes {
  double nodes = 1, derivative = 0;
};

/// Numbers and operations in the derivative of if(c, a, b): if(c, a', b'); of min(a, b): if(b - a, a', if(a - b, b', min(a', b'))).
double chosen_derivative(const std::vector<Sizes>& parts, double nodes, bool condition) {
  const double both = parts.back().derivative + parts[parts.size() - 2].derivative;
  if (both == 0) return 0;
  return condition ? 3 + parts[0].nodes + both : 10 + 2 * nodes + 2 * both;
}

Sizes sizes(const GiNaC::ex& e, const GiNaC::ex& variable) {
  Sizes all;
  if (e.nops() == 0) {
    all.derivative = e.is_equal(variable);
    return all;
  }
  std::vector<Sizes> parts;
  for (const GiNaC::ex& part : e) {
    parts.push_back(sizes(part, variable));
    all.nodes += parts.back().nodes;
  }
  if (choice_of(e) != Choice::NONE) {
    all.derivative = chosen_derivative(parts, all.nodes, choice_of(e) == Choice::CONDITION);
    return all;
  }
  const bool sum = GiNaC::is_a<GiNaC::add>(e), product = GiNaC::is_a<GiNaC::mul>(e);
  for (const Sizes& part : parts) {
    if (part.derivative == 0) continue;
    all.derivative += part.derivative; // and the factor beside it: the others; b^(e-1)*e, b^e*log(b); f'
    if (product) all.derivative += 1 + all.nodes - part.nodes;
    if (!sum && !product) all.derivative += 4 + 2 * all.nodes;
  }
  return all;
}

} // namespace

void require_moderate_power(const GiNaC::ex& base, const GiNaC::ex& exponent) {
  if (!GiNaC::is_a<GiNaC::numeric>(exponent)) return;
  const double size = std::abs(GiNaC::ex_to<GiNaC::numeric>(exponent).to_double());
  if (size <= 1 || size * binary_digits(base) <= LARGEST_POWER) return;
  std::ostringstream text;
  text << "its part (" << base << ")^(" << exponent << ") is too large to be computed exactly";
  throw std::invalid_argument(text.str());
}

double derivative_size(const GiNaC::ex& e, const GiNaC::ex& variable) {
  return sizes(e, variable).derivative;
}

double expanded_terms(const GiNaC::ex& e) {
  if (GiNaC::is_a<GiNaC::add>(e)) {
    double sum = 0;
    for (const GiNaC::ex& part : e) sum += expanded_terms(part);
    return sum;
  }
  if (GiNaC::is_a<GiNaC::mul>(e)) {
    double product = 1;
    for (const GiNaC::ex& part : e) product *= expanded_terms(part);
    return product;
  }
  if (!GiNaC::is_a<GiNaC::power>(e)) return 1;
  const double terms = expanded_terms(e.op(0));
  if (terms == 1 || !e.op(1).info(GiNaC::info_flags::posint)) return terms;
  const double n = GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_double(); // (n + terms - 1) over n
  return std::exp(std::lgamma(n + terms) - std::lgamma(n + 1) - std::lgamma(terms));
}

} // namespace burnish

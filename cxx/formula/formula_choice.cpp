#include "formula/formula_choice.hpp"

namespace burnish {
namespace {

using GiNaC::ex;

// Functions of GiNaC are known by a number, which it gives when they are registered.
unsigned min_number();
unsigned max_number();
unsigned if_number();

/// The value if it is a real number, pi for example; false if it is none yet.
bool is_number(const ex& e, GiNaC::numeric& value) {
  const ex number = GiNaC::is_a<GiNaC::numeric>(e) ? e : e.evalf();
  if (!GiNaC::is_a<GiNaC::numeric>(number)) return false;
  value = GiNaC::ex_to<GiNaC::numeric>(number);
  return value.is_real();
}

// --- values: what can be chosen now is ---------------------------------------------------------------

ex min_value(const ex& a, const ex& b) {
  GiNaC::numeric x, y;
  if (a.is_equal(b)) return a;
  if (is_number(a, x) && is_number(b, y)) return x < y ? a : b;
  return GiNaC::function(min_number(), a, b).hold();
}
ex max_value(const ex& a, const ex& b) {
  GiNaC::numeric x, y;
  if (a.is_equal(b)) return a;
  if (is_number(a, x) && is_number(b, y)) return x > y ? a : b;
  return GiNaC::function(max_number(), a, b).hold();
}
ex if_value(const ex& c, const ex& a, const ex& b) {
  GiNaC::numeric value;
  if (a.is_equal(b)) return a;
  if (is_number(c, value)) return value.is_positive() ? a : b;
  return GiNaC::function(if_number(), c, a, b).hold();
}

// --- derivatives --------------------------------------------------------------------------------------

ex min_slope(const ex& a, const ex& b, const GiNaC::symbol& variable) {
  const ex da = a.diff(variable), db = b.diff(variable);
  return if_value(b - a, da, if_value(a - b, db, min_value(da, db)));
}
ex max_slope(const ex& a, const ex& b, const GiNaC::symbol& variable) {
  const ex da = a.diff(variable), db = b.diff(variable);
  return if_value(a - b, da, if_value(b - a, db, max_value(da, db)));
}
ex if_slope(const ex& c, const ex& a, const ex& b, const GiNaC::symbol& variable) {
  return if_value(c, a.diff(variable), b.diff(variable));
}

// --- all of them are real -----------------------------------------------------------------------------

ex min_conjugate(const ex& a, const ex& b) { return min_value(a, b); }
ex max_conjugate(const ex& a, const ex& b) { return max_value(a, b); }
ex if_conjugate(const ex& c, const ex& a, const ex& b) { return if_value(c, a, b); }

template <class Value, class Slope>
unsigned registered(const char* name, unsigned arguments, Value value, Slope slope, Value conjugate) {
  GiNaC::function_options options(name, arguments);
  options.eval_func(value).expl_derivative_func(slope).conjugate_func(conjugate);
  return GiNaC::function::register_new(options);
}
unsigned min_number() {
  static const unsigned number = registered("min", 2, min_value, min_slope, min_conjugate);
  return number;
}
unsigned max_number() {
  static const unsigned number = registered("max", 2, max_value, max_slope, max_conjugate);
  return number;
}
unsigned if_number() {
  static const unsigned number = registered("if", 3, if_value, if_slope, if_conjugate);
  return number;
}

// --- comparisons: gone as soon as they are read -----------------------------------------------------------

ex greater_value(const ex& l, const ex& r, const ex& a, const ex& b) { return if_value(l - r, a, b); }
ex less_value(const ex& l, const ex& r, const ex& a, const ex& b) { return if_value(r - l, a, b); }
ex least_value(const ex& l, const ex& r, const ex& a, const ex& b) { return if_value(r - l, b, a); }
ex most_value(const ex& l, const ex& r, const ex& a, const ex& b) { return if_value(l - r, b, a); }

template <class Value> void register_comparison(const char* name, Value value) {
  GiNaC::function_options options(name, 4);
  options.eval_func(value);
  GiNaC::function::register_new(options);
}

/// Once, before GiNaC lists the functions that its parser knows.
bool registered_all() {
  min_number();
  max_number();
  if_number();
  register_comparison("if_greater", greater_value);
  register_comparison("if_less", less_value);
  register_comparison("if_least", least_value);
  register_comparison("if_most", most_value);
  return true;
}

} // namespace

const GiNaC::prototype_table& choice_reader() {
  static const bool ready = registered_all();
  static_cast<void>(ready);
  return GiNaC::get_default_reader();
}

Choice choice_of(const GiNaC::ex& e) {
  if (!GiNaC::is_a<GiNaC::function>(e)) return Choice::NONE;
  const unsigned number = GiNaC::ex_to<GiNaC::function>(e).get_serial();
  if (number == min_number()) return Choice::MINIMUM;
  if (number == max_number()) return Choice::MAXIMUM;
  return number == if_number() ? Choice::CONDITION : Choice::NONE;
}

} // namespace burnish

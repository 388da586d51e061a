#include "formula/formula_tape.hpp"
#include "base/error.hpp"
#include "formula/formula_choice.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace burnish {
namespace {

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

double power(double base, double exponent) {
  if (exponent == -1) return 1 / base;
  if (exponent == 2) return base * base;
  if (exponent == 0.5) return std::sqrt(base);
  if (exponent == -0.5) return 1 / std::sqrt(base);
  if (base == 0 && exponent <= 0) return NOT_A_NUMBER;
  return std::pow(base, exponent);
}

double same(double x) { return x; }
double zero(double) { return 0; }
double step(double x) { return x > 0 ? 1 : x < 0 ? 0 : 0.5; }
double sign(double x) { return (x > 0) - (x < 0); }

} // namespace

// conjugate and the parts of a real number come from derivatives
const std::map<std::string, FormulaTape::Function>& FormulaTape::table() {
  static const std::map<std::string, Function> table{
      {"sin", std::sin},   {"cos", std::cos},     {"tan", std::tan},     {"asin", std::asin},
      {"acos", std::acos}, {"atan", std::atan},   {"sinh", std::sinh},   {"cosh", std::cosh},
      {"tanh", std::tanh}, {"asinh", std::asinh}, {"acosh", std::acosh}, {"atanh", std::atanh},
      {"exp", std::exp},   {"log", std::log},     {"abs", std::fabs},    {"step", step},
      {"csgn", sign},      {"conjugate", same},   {"real_part", same},   {"imag_part", zero}};
  return table;
}

const std::vector<std::string>& FormulaTape::functions() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list{"atan2", "if", "max", "min"};
    for (const auto& [name, function] : table())
      if (name != "conjugate" && name != "real_part" && name != "imag_part") list.push_back(name);
    std::sort(list.begin(), list.end());
    return list;
  }();
  return names;
}

struct FormulaTape::Compiler {
  using Key = std::pair<std::string, std::string>;
  const std::vector<GiNaC::realsymbol>& variables;
  std::vector<Operation>& operations;
  std::vector<double> constants; ///< values of the operations, NaN for those that are no constants
  std::map<GiNaC::ex, int, GiNaC::ex_is_less> known;
  std::map<GiNaC::ex, Key, GiNaC::ex_is_less> keys;

  /// Number of the operation that gives the expression.
  int operator()(const GiNaC::ex& e) {
    if (const auto found = known.find(e); found != known.end()) return found->second;
    const int number = translated(e);
    known[e] = number;
    return number;
  }
  int append(Operation operation) {
    if (operation.kind == Kind::VARIABLE) {
      constants.push_back(NOT_A_NUMBER);
    } else if (unknown_operand(operation, constants.data()) < 0) {
      const double value = apply(operation, nullptr, constants.data());
      if (!std::isfinite(value))
        throw std::invalid_argument("its part " + describe(operation, nullptr, constants.data()) +
                                    " is no finite real number");
      constants.push_back(value);
      operation = {Kind::CONSTANT, 0, 0, value};
    } else {
      constants.push_back(NOT_A_NUMBER);
    }
    operations.push_back(operation);
    return static_cast<int>(operations.size()) - 1;
  }
  int translated(const GiNaC::ex& e) {
    for (std::size_t k = 0; k < variables.size(); ++k)
      if (e.is_equal(variables[k])) return append({Kind::VARIABLE, static_cast<int>(k)});
    if (GiNaC::is_a<GiNaC::numeric>(e) || GiNaC::is_a<GiNaC::constant>(e)) return constant(e);
    if (GiNaC::is_a<GiNaC::add>(e)) return chain(Kind::ADD, e);
    if (GiNaC::is_a<GiNaC::mul>(e)) return chain(Kind::MULTIPLY, e);
    if (GiNaC::is_a<GiNaC::power>(e)) return pair(Kind::POWER, e);
    if (GiNaC::is_a<GiNaC::function>(e) && !GiNaC::is_a<GiNaC::fderivative>(e)) return function(e);
    return unknown(e);
  }
  int constant(const GiNaC::ex& e) {
    const auto number = GiNaC::ex_to<GiNaC::numeric>(e.evalf());
    Operation operation{Kind::CONSTANT};
    operation.constant = number.is_real() ? number.to_double() : NOT_A_NUMBER;
    if (!std::isfinite(operation.constant) || (operation.constant == 0 && !number.is_zero())) {
      std::ostringstream part;
      part << number;
      throw std::invalid_argument("its part " + part.str() +
                                  " is no finite real number in the range of double");
    }
    return append(operation);
  }
  int pair(Kind kind, const GiNaC::ex& e) {
    const int a = (*this)(e.op(0));
    return append({kind, a, (*this)(e.op(1))});
  }
  int chain(Kind kind, const GiNaC::ex& e) {
    std::multimap<Key, GiNaC::ex> operands;
    for (const GiNaC::ex& operand : e) operands.emplace(key(operand), operand);
    int result = -1;
    for (const auto& [place, operand] : operands) {
      const int next = (*this)(operand);
      result = result < 0 ? next : append({kind, result, next});
    }
    return result;
  }
  int function(const GiNaC::ex& e) {
    if (name(e) == "atan2") return pair(Kind::ATAN2, e);
    if (choice_of(e) == Choice::MINIMUM) return pair(Kind::MINIMUM, e);
    if (choice_of(e) == Choice::MAXIMUM) return pair(Kind::MAXIMUM, e);
    if (choice_of(e) == Choice::CONDITION) return condition(e);
    const auto found = table().find(name(e));
    if (found == table().end()) return unknown(e);
    const int a = (*this)(e.op(0));
    return append({Kind::FUNCTION, a, a, 0, found->second, found->first.c_str()});
  }
  int condition(const GiNaC::ex& e) {
    Operation operation{Kind::CONDITION};
    operation.condition = (*this)(e.op(0));
    operation.a = (*this)(e.op(1));
    operation.b = (*this)(e.op(2));
    return append(operation);
  }
  /// Where an operand of a sum or product belongs: the expression in postfix notation, its sums and products
  /// sorted, first without signs (GiNaC may turn those of a factor), then with them.
  const Key& key(const GiNaC::ex& e) {
    if (const auto found = keys.find(e); found != keys.end()) return found->second;
    std::ostringstream last;
    if (e.nops() == 0) {
      last << e;
      const bool number = GiNaC::is_a<GiNaC::numeric>(e);
      return keys[e] = number ? Key("!" + last.str().substr(last.str()[0] == '-'), "!" + last.str())
                              : Key(last.str(), last.str());
    }
    const bool sum = GiNaC::is_a<GiNaC::add>(e), product = GiNaC::is_a<GiNaC::mul>(e);
    std::vector<Key> parts;
    for (const GiNaC::ex& part : e) parts.push_back(key(part));
    // the coefficient of a product comes last in GiNaC, and stays there: x, -x, x*y
    const bool scaled = product && GiNaC::is_a<GiNaC::numeric>(e.op(e.nops() - 1));
    if (sum || product) std::sort(parts.begin(), parts.end() - scaled);
    last << (sum ? "+" : product ? "*" : GiNaC::is_a<GiNaC::power>(e) ? "^" : name(e)) << e.nops();
    Key text;
    for (const Key& part : parts) text = {text.first + part.first + " ", text.second + part.second + " "};
    return keys[e] = {text.first + last.str(), text.second + last.str()};
  }
  static std::string name(const GiNaC::ex& e) { return GiNaC::ex_to<GiNaC::function>(e).get_name(); }
  [[noreturn]] static int unknown(const GiNaC::ex& e) {
    std::ostringstream part;
    part << e;
    throw std::invalid_argument("its part " + part.str() + " cannot be evaluated");
  }
};

FormulaTape::FormulaTape(const GiNaC::ex& expression, const std::vector<GiNaC::realsymbol>& variables) {
  Compiler{variables, m_operations, {}, {}, {}}(expression);
}

double FormulaTape::apply(const Operation& operation, const double* values, const double* results) {
  switch (operation.kind) {
  case Kind::CONSTANT:
    return operation.constant;
  case Kind::VARIABLE:
    return values[operation.a];
  case Kind::ADD:
    return results[operation.a] + results[operation.b];
  case Kind::MULTIPLY:
    return results[operation.a] * results[operation.b];
  case Kind::POWER:
    return power(results[operation.a], results[operation.b]);
  case Kind::FUNCTION:
    return operation.function(results[operation.a]);
  case Kind::ATAN2:
    return std::atan2(results[operation.a], results[operation.b]);
  case Kind::MINIMUM:
    return std::min(results[operation.a], results[operation.b]);
  case Kind::MAXIMUM:
    return std::max(results[operation.a], results[operation.b]);
  case Kind::CONDITION:
    return results[results[operation.condition] > 0 ? operation.a : operation.b];
  }
  return NOT_A_NUMBER;
}

/// The earlier operation that counts here and has no value, -1 if all have one.
int FormulaTape::unknown_operand(const Operation& operation, const double* results) {
  const auto unknown = [&](int operand) { return std::isnan(results[operand]); };
  if (operation.kind == Kind::CONSTANT || operation.kind == Kind::VARIABLE) return -1;
  if (operation.kind == Kind::CONDITION) {
    if (unknown(operation.condition)) return operation.condition;
    const int taken = results[operation.condition] > 0 ? operation.a : operation.b;
    return unknown(taken) ? taken : -1;
  }
  return unknown(operation.a) ? operation.a : unknown(operation.b) ? operation.b : -1;
}

double FormulaTape::evaluated(const Operation& operation, const double* values, const double* results) {
  if (unknown_operand(operation, results) >= 0) return NOT_A_NUMBER;
  const double value = apply(operation, values, results);
  return std::isfinite(value) ? value : NOT_A_NUMBER;
}

double FormulaTape::operator()(const double* values) const {
  thread_local std::vector<double> results;
  if (results.size() < m_operations.size()) results.resize(m_operations.size());
  double result = 0;
  for (std::size_t i = 0; i < m_operations.size(); ++i)
    result = results[i] = evaluated(m_operations[i], values, results.data());
  return result;
}

std::string FormulaTape::failure(const double* values) const {
  std::vector<double> results;
  for (const Operation& operation : m_operations)
    results.push_back(evaluated(operation, values, results.data()));
  if (results.empty() || !std::isnan(results.back())) return "";
  int failed = static_cast<int>(results.size()) - 1;
  const auto operation = [&]() -> const Operation& { return m_operations[static_cast<std::size_t>(failed)]; };
  for (int next = failed; next >= 0; next = unknown_operand(operation(), results.data())) failed = next;
  return describe(operation(), values, results.data());
}

std::string FormulaTape::describe(const Operation& operation, const double* values, const double* results) {
  std::ostringstream text;
  const auto a = [&] { return results[operation.a]; };
  const auto b = [&] { return results[operation.b]; };
  switch (operation.kind) {
  case Kind::CONSTANT:
    text << operation.constant;
    break;
  case Kind::VARIABLE:
    text << "the value " << values[operation.a];
    break;
  case Kind::ADD:
    text << a() << " + " << b();
    break;
  case Kind::MULTIPLY:
    text << a() << " * " << b();
    break;
  case Kind::POWER:
    if (b() == -1)
      text << "1/" << a();
    else if (b() == 0.5)
      text << "sqrt(" << a() << ")";
    else
      text << "(" << a() << ")^(" << b() << ")";
    break;
  case Kind::FUNCTION:
    text << operation.name << "(" << a() << ")";
    break;
  case Kind::ATAN2:
    text << "atan2(" << a() << ", " << b() << ")";
    break;
  case Kind::MINIMUM:
  case Kind::MAXIMUM:
  case Kind::CONDITION: // what they choose from has failed before
    break;
  }
  return text.str();
}

} // namespace burnish

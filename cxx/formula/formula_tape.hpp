#pragma once
// A GiNaC expression as a list of operations on doubles: some 200 times faster than GiNaC's own evaluation.
#include <ginac/ginac.h>
#include <map>
#include <string>
#include <vector>

namespace burnish {

/// Immutable; equal subexpressions are computed once. Sums and products are taken in an order that depends on
/// the formula only, so that every run gives the same last bit (GiNaC's own order changes from run to run).
/// Values agree with GiNaC's to 1e-14 relative to the largest intermediate result. Functions are those of the
/// C++ library: GiNaC's own numbers are slow (16 microseconds where the tape takes 0.1) and not all safe (its
/// tgamma has errors of 1e-10, its exp(exp(1000)) gives 1).
class FormulaTape {
public:
  FormulaTape() = default;
  /// @param expression  made of numbers, the variables, sums, products, powers and functions()
  /// @param variables   in the order of the values
  /// @throws std::invalid_argument if a constant part is no finite real number, such as acos(2), or for
  /// another kind of expression
  FormulaTape(const GiNaC::ex& expression, const std::vector<GiNaC::realsymbol>& variables);
  /// Value, or NaN where one of the operations gives no finite real number; those of the branch that an if does not take do
  /// not count. values: one per variable.
  double operator()(const double* values) const;
  /// The operation without a finite real result that the value fails for, in numbers: "1/0", "log(-1)"; empty if there is
  /// none.
  std::string failure(const double* values) const;
  /// Names of the functions that the tape knows, sorted, beside sqrt, pow and power, which are powers.
  static const std::vector<std::string>& functions();

private:
  enum class Kind { CONSTANT, VARIABLE, ADD, MULTIPLY, POWER, FUNCTION, ATAN2, MINIMUM, MAXIMUM, CONDITION };
  using Function = double (*)(double);
  struct Operation {
    Kind kind = Kind::CONSTANT;
    int a = 0, b = 0;            ///< earlier operations; of VARIABLE: a its number
    double constant = 0;         ///< of CONSTANT
    Function function = nullptr; ///< of FUNCTION
    const char* name = "";       ///< of FUNCTION
    int condition = 0; ///< of CONDITION: the earlier operation that chooses, a where it is > 0, else b
  };
  struct Compiler;
  static const std::map<std::string, Function>& table();
  static double apply(const Operation& operation, const double* values, const double* results);
  static int unknown_operand(const Operation& operation, const double* results);
  static double evaluated(const Operation& operation, const double* values, const double* results);
  static std::string describe(const Operation& operation, const double* values, const double* results);
  std::vector<Operation> m_operations; ///< the last one is the value
};

} // namespace burnish

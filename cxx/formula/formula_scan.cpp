#include "formula/formula_scan.hpp"
#include "base/error.hpp"
#include "formula/formula.hpp"
#include "formula/formula_calls.hpp"
#include "formula/formula_choice.hpp"
#include "formula/formula_size.hpp"
#include "formula/formula_tape.hpp"
#include "formula/formula_tokens.hpp"
#include <algorithm>
#include <cln/cln.h>
#include <cmath>
#include <set>
#include <sstream>

namespace burnish {
namespace {

using Kind = FormulaToken::Kind;
constexpr std::size_t LONGEST_NAME = 100;

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string known_names(const GiNaC::symtab& table) {
  std::vector<std::string> names;
  for (const auto& [name, expression] : table)
    if (name != "Pi") names.push_back(name);
  return listed(names);
}

/// Functions that a formula may call: those of the tape, and what is read as others.
const std::vector<std::string>& functions() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list = FormulaTape::functions();
    std::replace(list.begin(), list.end(), std::string("csgn"), std::string("sign"));
    list.insert(list.end(), {"sqrt", "pow"});
    return list;
  }();
  return names;
}

int arguments_of(const std::string& function) {
  static const std::set<std::string> two{"atan2", "pow", "min", "max"};
  return function == "if" ? 3 : two.count(function) ? 2 : 1;
}

bool is_function(const std::string& name) {
  return std::count(functions().begin(), functions().end(), name) > 0;
}

void check_word(const std::vector<FormulaToken>& tokens, std::size_t i, const GiNaC::symtab& table) {
  const FormulaToken& token = tokens[i];
  const bool called = i + 1 < tokens.size() && tokens[i + 1].kind == Kind::OPEN;
  const bool known = table.count(token.text);
  if (called && known) wrong_formula(token.start, "\"" + token.text + "\" is no function; a product needs *");
  if (called && !is_function(token.text))
    wrong_formula(token.start,
                  "unknown function \"" + token.text + "\", expected one of " + listed(functions()));
  if (called && i + 2 < tokens.size() && tokens[i + 2].kind == Kind::CLOSE)
    wrong_formula(token.start, "function \"" + token.text + "\" has no argument");
  if (!called && !known && is_function(token.text))
    wrong_formula(token.start, "function \"" + token.text + "\" needs its argument in parentheses");
  if (!called && !known)
    wrong_formula(token.start, "unknown name \"" + token.text + "\", expected one of " + known_names(table));
}

/// What GiNaC would misread or report without a place.
void check_tokens(const std::vector<FormulaToken>& tokens, const GiNaC::symtab& table) {
  if (tokens.empty()) throw std::invalid_argument("the formula is empty");
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const FormulaToken& token = tokens[i];
    if (token.kind == Kind::WORD) check_word(tokens, i, table);
    if (i == 0) continue;
    const Kind before = tokens[i - 1].kind;
    const bool operand = token.kind == Kind::NUMBER || token.kind == Kind::WORD || token.kind == Kind::OPEN;
    if ((token.text == "-" || token.text == "+") && before == Kind::OPERATOR)
      wrong_formula(token.start, "a sign after an operator needs parentheses, as in x*(-y)");
    if (operand && (before == Kind::NUMBER || before == Kind::CLOSE ||
                    (before == Kind::WORD && token.kind != Kind::OPEN)))
      wrong_formula(token.start, "an operator is missing before \"" + token.text + "\"");
  }
}

void check_calls(const std::vector<FormulaToken>& tokens, const std::vector<FormulaCall>& calls) {
  for (const FormulaCall& call : calls) {
    const FormulaToken& word = tokens[call.word];
    const int expected = arguments_of(word.text);
    if (call.arguments != expected)
      wrong_formula(word.start, "function \"" + word.text + "\" has " + std::to_string(call.arguments) +
                                    (call.arguments == 1 ? " argument" : " arguments") + ", expected " +
                                    std::to_string(expected));
  }
}

/// Words of tokens that GiNaC reads by other names: if(x > y, a, b) is if_greater(x, y, a, b).
std::map<std::size_t, std::string> other_words(const std::vector<FormulaToken>& tokens,
                                               const std::vector<FormulaCall>& calls) {
  static const std::map<std::string, std::string> comparisons{
      {">", "if_greater"}, {"<", "if_less"}, {">=", "if_least"}, {"<=", "if_most"}};
  std::map<std::size_t, std::string> words;
  for (const FormulaCall& call : calls) {
    if (tokens[call.word].text == "sign") words[call.word] = "csgn";
    if (!call.comparison) continue;
    words[call.word] = comparisons.at(tokens[call.comparison].text);
    words[call.comparison] = ",";
  }
  return words;
}

/// What GiNaC reads, and where each token begins in it. Numbers, parameters and constants are symbols of
/// their own in it: GiNaC would compute their powers at once, however large.
struct SymbolicText {
  std::string text;
  std::vector<std::size_t> starts;
  GiNaC::symtab table;
  std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less> values; ///< of these symbols

  /// @param other words in place of those of tokens
  SymbolicText(const std::vector<FormulaToken>& tokens, const std::map<std::size_t, std::string>& other,
               const GiNaC::symtab& names) {
    for (const auto& [name, expression] : names)
      if (GiNaC::is_a<GiNaC::symbol>(expression))
        table[name] = expression;
      else
        add(name, expression);
    for (const FormulaToken& token : tokens) {
      const auto found = other.find(starts.size());
      std::string word = found == other.end() ? token.text : found->second;
      starts.push_back(text.size());
      if (token.kind == Kind::NUMBER) {
        word = "number" + std::to_string(starts.size());
        while (names.count(word)) word += "_";
        add(word, token_number(token));
      }
      text += word + " ";
    }
  }

private:
  void add(const std::string& name, const GiNaC::ex& value) {
    const GiNaC::realsymbol symbol(name);
    table[name] = symbol;
    values[symbol] = value;
  }
};

/// GiNaC counts no columns. When it fails it has read its token and one character more.
std::string place_of_failure(std::istringstream& stream, const std::vector<FormulaToken>& tokens,
                             const SymbolicText& symbolic) {
  stream.clear();
  const auto read = static_cast<std::size_t>(stream.tellg());
  std::size_t last = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (symbolic.starts[i] + 2 <= read) last = tokens[i].start;
  return "at character " + std::to_string(last + 1);
}

std::string syntax_message(const std::string& message, std::istringstream& stream,
                           const std::vector<FormulaToken>& tokens, const SymbolicText& symbolic) {
  if (message.find("power should have") != std::string::npos)
    return "a^b^c is ambiguous, write a^(b^c) or (a^b)^c";
  if (message.find("got: EOF") != std::string::npos)
    return std::string("the formula ends too early") +
           (message.find("')'") != std::string::npos ? ", a \")\" is missing" : "");
  const std::size_t start = message.find("column 0: ");
  std::string text = start == std::string::npos ? message : message.substr(start + 10);
  text = text.substr(0, text.find('\n'));
  if (const std::size_t end = text.find("EOF"); end != std::string::npos) text.replace(end, 3, "the end");
  return place_of_failure(stream, tokens, symbolic) + ": " + text;
}

/// Puts the values in; the parts that become constant are computed exactly.
struct InsertValues : GiNaC::map_function {
  const std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less>& values;
  explicit InsertValues(const std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less>& v) : values(v) {}
  GiNaC::ex operator()(const GiNaC::ex& e) override {
    if (GiNaC::is_a<GiNaC::symbol>(e)) {
      const auto found = values.find(e);
      return found == values.end() ? e : found->second;
    }
    if (choice_of(e) == Choice::CONDITION) return chosen(e);
    if (GiNaC::is_a<GiNaC::power>(e)) {
      const GiNaC::ex base = (*this)(e.op(0)), exponent = (*this)(e.op(1));
      require_moderate_power(base, exponent);
      if (base.is_zero() && exponent.evalf().info(GiNaC::info_flags::positive)) return 0; // GiNaC leaves 0^pi
      return real(GiNaC::pow(base, exponent), [&](std::ostream& part) {
        if (exponent.is_equal(GiNaC::ex(1) / 2))
          part << "sqrt(" << base << ")";
        else
          part << "(" << base << ")^(" << exponent << ")";
      });
    }
    return real(e.map(*this), [&](std::ostream& part) {
      if (GiNaC::is_a<GiNaC::function>(e))
        describe_call(part, e);
      else
        part << e;
    });
  }

private:
  /// What is not taken is not computed: if(k, a/k, 0) with k = 0.
  GiNaC::ex chosen(const GiNaC::ex& e) {
    const GiNaC::ex condition = (*this)(e.op(0)), number = condition.evalf();
    if (GiNaC::is_a<GiNaC::numeric>(number))
      return (*this)(e.op(GiNaC::ex_to<GiNaC::numeric>(number).is_positive() ? 1 : 2));
    return e.map(*this);
  }
  void describe_call(std::ostream& part, const GiNaC::ex& e) {
    part << GiNaC::ex_to<GiNaC::function>(e).get_name();
    for (std::size_t i = 0; i < e.nops(); ++i) part << (i ? ", " : "(") << (*this)(e.op(i));
    part << ")";
  }
  template <class Describe> static GiNaC::ex real(const GiNaC::ex& e, const Describe& describe) {
    for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
      if (GiNaC::is_a<GiNaC::numeric>(*part) && !GiNaC::ex_to<GiNaC::numeric>(*part).is_real()) {
        std::ostringstream text;
        describe(text);
        throw std::invalid_argument("its part " + text.str() + " is no finite real number");
      }
    return e;
  }
};

} // namespace

void check_formula_names(const std::string& where, const FormulaNames& names) {
  static const std::set<std::string> constants{"I", "Pi", "pi", "Euler", "Catalan"};
  std::set<std::string> known;
  const auto check = [&](const std::string& name) {
    if (!is_identifier(name))
      fail_at(where, "name " + quoted(name) + " is no identifier (a letter, then letters, digits and _)");
    if (name.size() > LONGEST_NAME)
      fail_at(where,
              "name " + quoted(name) + ", expected at most " + std::to_string(LONGEST_NAME) + " characters");
    if (is_function(name) || constants.count(name))
      fail_at(where, "name \"" + name + "\" is taken by a " + (is_function(name) ? "function" : "constant"));
    if (!known.insert(name).second) fail_at(where, "name " + quoted(name) + " occurs twice");
  };
  for (const std::string& name : names.variables) check(name);
  for (const auto& [name, value] : names.parameters) {
    check(name);
    require(std::isfinite(value), where.c_str(), ("parameter " + quoted(name)).c_str(), value,
            "a finite number");
    require(value == 0 || std::isnormal(value), where.c_str(), ("parameter " + quoted(name)).c_str(), value,
            "zero or a number that double holds in full");
  }
}

std::string quoted(const std::string& text) {
  constexpr std::size_t SHOWN = 200;
  std::string beginning = text.substr(0, SHOWN);
  std::replace(beginning.begin(), beginning.end(), '\0', '?'); // would end a message
  if (text.size() <= SHOWN) return "\"" + beginning + "\"";
  return "\"" + beginning + "...\" (" + std::to_string(text.size()) + " characters)";
}

GiNaC::numeric exact_number(double value) { return GiNaC::numeric(cln::rationalize(cln::cl_R(value))); }

GiNaC::ex parse_formula(const std::string& text, const GiNaC::symtab& table) {
  const std::vector<FormulaToken> tokens = formula_tokens(text);
  check_tokens(tokens, table);
  const std::vector<FormulaCall> calls = formula_calls(tokens);
  check_calls(tokens, calls);
  const SymbolicText symbolic(tokens, other_words(tokens, calls), table);
  GiNaC::parser parser(symbolic.table, true, choice_reader());
  std::istringstream stream(symbolic.text);
  GiNaC::ex result;
  try {
    result = parser(stream);
  } catch (const GiNaC::parse_error& error) {
    throw std::invalid_argument(syntax_message(error.what(), stream, tokens, symbolic));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(syntax_message(error.what(), stream, tokens, symbolic));
  }
  return InsertValues(symbolic.values)(result);
}

} // namespace burnish

#include "formula/formula.hpp"
#include "base/error.hpp"
#include "formula/formula_choice.hpp"
#include "formula/formula_scan.hpp"
#include "formula/formula_size.hpp"
#include "formula/formula_tape.hpp"
#include <cmath>
#include <sstream>

namespace burnish {
namespace {

constexpr long LARGEST_DERIVATIVE = 1000000;
constexpr double MOST_TERMS = 1000; ///< of a derivative that is expanded

/// "beta = 1.5, r = 2", for messages.
std::string place(const std::vector<std::string>& names, const double* values) {
  std::ostringstream text;
  text.precision(10);
  for (std::size_t i = 0; i < names.size(); ++i) text << (i ? ", " : "") << names[i] << " = " << values[i];
  return text.str();
}

bool is_step(const GiNaC::ex& e) {
  if (!GiNaC::is_a<GiNaC::function>(e)) return false;
  const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
  return name == "step" || name == "csgn";
}

/// Steps stand as symbols while the rest is differentiated: they count as flat, and GiNaC 1.8 takes the
/// conjugate of a step's derivative, which it meets in that of abs, for the step itself. A constant exponent becomes a number: that of
/// a power of pi would else be taken by the logarithm, which has no value where the base is 0.
struct FrozenSteps : GiNaC::map_function {
  GiNaC::exmap steps, symbols; ///< symbol to step, step to symbol
  GiNaC::ex operator()(const GiNaC::ex& e) override {
    if (GiNaC::is_a<GiNaC::power>(e) && !GiNaC::is_a<GiNaC::numeric>(e.op(1))) {
      const GiNaC::ex exponent = e.op(1).evalf();
      if (GiNaC::is_a<GiNaC::numeric>(exponent) && exponent.info(GiNaC::info_flags::real))
        return GiNaC::pow((*this)(e.op(0)), exponent);
    }
    if (!is_step(e)) return e.map(*this);
    const auto [found, added] = symbols.try_emplace(e, GiNaC::realsymbol());
    if (added) steps[found->second] = e;
    return found->second;
  }
};

/// True if the value may jump where the variable changes, by a step or a condition.
bool jumps(const GiNaC::ex& e, const GiNaC::ex& variable) {
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
    if ((is_step(*part) || choice_of(*part) == Choice::CONDITION) && part->op(0).has(variable)) return true;
  return false;
}

} // namespace

/// What a formula shares with its derivatives.
struct Formula::Source {
  std::string what, text;
  std::vector<std::string> names;
  std::vector<GiNaC::realsymbol> variables;
};

struct Formula::Impl {
  std::shared_ptr<const Source> source;
  std::string label; ///< of a derivative, for messages
  GiNaC::ex expression;
  FormulaTape tape;

  std::string where() const { return source->what + " " + quoted(source->text) + label; }
  [[noreturn]] void refuse(const std::string& why) const {
    const std::size_t place = why.find("(): "); // GiNaC's begin with its own place: "power::eval(): "
    fail_at(where(), place == std::string::npos ? why : why.substr(place + 4));
  }
  void compile() {
    try {
      tape = FormulaTape(expression, source->variables);
    } catch (const std::exception& error) {
      refuse(error.what());
    }
  }
  void differentiate(const GiNaC::realsymbol& variable) {
    if (!(derivative_size(expression, variable) <= LARGEST_DERIVATIVE))
      refuse("the formula is too long to be differentiated, expected a derivative of at most " +
             std::to_string(LARGEST_DERIVATIVE) + " numbers, names and operations");
    try {
      FrozenSteps frozen;
      const GiNaC::ex smooth = frozen(expression);
      expression = smooth.diff(variable).subs(frozen.steps);
    } catch (const std::exception& error) {
      refuse(error.what());
    }
  }
};

Formula::Formula(std::string what, std::string text, const FormulaNames& names) {
  auto source = std::make_shared<Source>();
  source->what = std::move(what);
  source->text = std::move(text);
  source->names = names.variables;
  auto impl = std::make_shared<Impl>();
  impl->source = source;
  GiNaC::symtab table{{"pi", GiNaC::Pi}, {"Pi", GiNaC::Pi}};
  check_formula_names(impl->where(), names);
  try {
    for (const std::string& name : names.variables) {
      source->variables.push_back(GiNaC::realsymbol(name));
      table[name] = source->variables.back();
    }
    for (const auto& [name, value] : names.parameters) table[name] = exact_number(value);
    impl->expression = parse_formula(source->text, table);
  } catch (const std::exception& error) {
    impl->refuse(error.what());
  }
  impl->compile();
  m_impl = std::move(impl);
}

double Formula::operator()(const double* values) const {
  const double value = m_impl->tape(values);
  if (!std::isnan(value)) return value;
  const std::string where = place(m_impl->source->names, values);
  throw FormulaDomainError(m_impl->where() + ": " + m_impl->tape.failure(values) +
                           " is no finite real number" + (where.empty() ? "" : ", at " + where));
}

Formula Formula::derivative(int variable) const {
  const int count = static_cast<int>(m_impl->source->variables.size());
  require(variable >= 0 && variable < count, "Formula::derivative", "variable", variable,
          ("0 to " + std::to_string(count - 1)).c_str());
  const auto k = static_cast<std::size_t>(variable);
  auto impl = std::make_shared<Impl>(*m_impl);
  impl->label += (impl->label.empty() ? ", derivative by " : " and ") + impl->source->names[k];
  impl->differentiate(impl->source->variables[k]);
  impl->compile();
  Formula result(*this);
  result.m_impl = std::move(impl);
  return result;
}

bool Formula::depends_on(int variable) const {
  const GiNaC::ex slope = derivative(variable).m_impl->expression;
  if (jumps(m_impl->expression, m_impl->source->variables[static_cast<std::size_t>(variable)])) return true;
  if (expanded_terms(slope) > MOST_TERMS) return !slope.is_zero();
  try {
    return !slope.expand().is_zero();
  } catch (const std::exception&) { // an exponent of more than 32 bits
    return !slope.is_zero();
  }
}

const std::string& Formula::text() const { return m_impl->source->text; }

} // namespace burnish

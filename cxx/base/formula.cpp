#include "base/formula.hpp"
#include "base/error.hpp"
#include "base/formula_scan.hpp"
#include "base/formula_tape.hpp"
#include <cmath>
#include <sstream>

namespace burnish {
namespace {

/// "beta = 1.5, r = 2", for messages.
std::string place(const std::vector<std::string>& names, const double* values) {
  std::ostringstream text;
  text.precision(10);
  for (std::size_t i = 0; i < names.size(); ++i) text << (i ? ", " : "") << names[i] << " = " << values[i];
  return text.str();
}

/// GiNaC leaves the derivatives of its steps open: zero except at the step.
struct FlatSteps : GiNaC::map_function {
  GiNaC::ex operator()(const GiNaC::ex& e) override {
    if (GiNaC::is_a<GiNaC::fderivative>(e)) {
      const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
      if (name == "step" || name == "csgn") return 0;
      throw std::invalid_argument("function \"" + name + "\" has no derivative");
    }
    return e.map(*this);
  }
};

} // namespace

struct Formula::Impl {
  std::string what, text, label; ///< label: of a derivative, for messages
  std::vector<std::string> names;
  std::vector<GiNaC::realsymbol> variables;
  GiNaC::ex expression;
  FormulaTape tape;

  std::string where() const { return what + " \"" + text + "\"" + label; }
  [[noreturn]] void refuse(const std::string& why) const { fail(where(), why); }
  void compile() {
    try {
      tape = FormulaTape(expression, variables);
    } catch (const std::exception& error) {
      refuse(error.what());
    }
  }
  void differentiate(std::size_t variable) {
    FlatSteps flat_steps;
    try {
      expression = flat_steps(expression.diff(variables[variable]));
    } catch (const std::exception& error) {
      refuse(error.what());
    }
  }
};

Formula::Formula(std::string what, std::string text, const FormulaNames& names) {
  auto impl = std::make_shared<Impl>();
  impl->what = std::move(what);
  impl->text = std::move(text);
  impl->names = names.variables;
  GiNaC::symtab table{{"pi", GiNaC::Pi}, {"Pi", GiNaC::Pi}};
  check_formula_names(impl->where(), names);
  try {
    for (const std::string& name : names.variables) {
      impl->variables.push_back(GiNaC::realsymbol(name));
      table[name] = impl->variables.back();
    }
    for (const auto& [name, value] : names.parameters) table[name] = exact_number(value);
    impl->expression = parse_formula(impl->text, table);
  } catch (const std::exception& error) {
    const std::string text = error.what(); // GiNaC's begin with its own place: "power::eval(): "
    const std::size_t place = text.find("(): ");
    impl->refuse(place == std::string::npos ? text : text.substr(place + 4));
  }
  impl->compile();
  m_impl = std::move(impl);
}

double Formula::operator()(const double* values) const {
  const double value = m_impl->tape(values);
  if (!std::isnan(value)) return value;
  const std::string where = place(m_impl->names, values);
  m_impl->refuse(m_impl->tape.failure(values) + " is no finite real number" +
                 (where.empty() ? "" : ", at " + where));
}

Formula Formula::derivative(int variable) const {
  const int count = static_cast<int>(m_impl->variables.size());
  require(variable >= 0 && variable < count, "Formula::derivative", "variable", variable,
          ("0 to " + std::to_string(count - 1)).c_str());
  const auto k = static_cast<std::size_t>(variable);
  auto impl = std::make_shared<Impl>(*m_impl);
  impl->label += (impl->label.empty() ? ", derivative by " : " and ") + impl->names[k];
  impl->differentiate(k);
  impl->compile();
  Formula result(*this);
  result.m_impl = std::move(impl);
  return result;
}

bool Formula::depends_on(int variable) const {
  return !derivative(variable).m_impl->expression.expand().is_zero();
}

const std::string& Formula::text() const { return m_impl->text; }

} // namespace burnish

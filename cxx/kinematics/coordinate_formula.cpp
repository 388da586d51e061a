#include "kinematics/coordinate_formula.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

constexpr double LEAST_WAY = 1e-100; // from a kink at zero, see CoordinateFormula::beside

} // namespace

CoordinateFormula::CoordinateFormula(const std::string& what, const std::string& text,
                                     const FormulaNames& names, bool second)
    : m_source{what, text, names, second}, m_value(what, text, names) {
  for (int v = 0; v < static_cast<int>(names.variables.size()); ++v)
    if (m_value.depends_on(v)) m_arguments.push_back(v);
  for (const int v : m_arguments) m_first.push_back(m_value.derivative(v));
  for (std::size_t i = 0; second && i < m_arguments.size(); ++i) {
    m_second.emplace_back();
    for (std::size_t j = 0; j <= i; ++j) m_second.back().push_back(m_first[i].derivative(m_arguments[j]));
  }
}

// A derivative, or where it has no value the one a rounding further on.
double CoordinateFormula::beside(const Formula& derivative, const double* values, std::size_t size) const {
  try {
    return derivative(values);
  } catch (const FormulaDomainError&) {
    std::vector<double> near(values, values + size);
    for (const int v : m_arguments) {
      double& x = near[static_cast<std::size_t>(v)];
      x += std::max(LEAST_WAY, 2 * std::numeric_limits<double>::epsilon() * std::abs(x));
    }
    return derivative(near.data());
  }
}

double CoordinateFormula::first(std::size_t i, const double* values, std::size_t size) const {
  return beside(m_first[i], values, size);
}

double CoordinateFormula::second(std::size_t i, std::size_t j, const double* values, std::size_t size) const {
  return beside(m_second[std::max(i, j)][std::min(i, j)], values, size);
}

std::shared_ptr<const CoordinateFormula> force_formula(const std::string& tool, const std::string& coordinate,
                                                       const std::string& text,
                                                       const std::vector<std::string>& names,
                                                       const std::map<std::string, double>& parameters) {
  FormulaNames known{names, parameters};
  const bool taken = parameters.count("t") > 0 || std::find(names.begin(), names.end(), "t") != names.end();
  if (!taken) known.variables.emplace_back("t");
  return std::make_shared<CoordinateFormula>("force \"" + coordinate + "\" of tool \"" + tool + "\"", text,
                                             known, false);
}

std::shared_ptr<const CoordinateFormula> motion_formula(const std::string& tool,
                                                        const std::string& coordinate,
                                                        const std::string& text,
                                                        const std::map<std::string, double>& parameters) {
  return std::make_shared<CoordinateFormula>("motion \"" + coordinate + "\" of tool \"" + tool + "\"", text,
                                             FormulaNames{{"t"}, parameters}, false);
}

} // namespace burnish

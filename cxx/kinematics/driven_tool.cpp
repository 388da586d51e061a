#include "kinematics/driven_tool.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {

template <int Dim>
DrivenTool<Dim>::DrivenTool(std::string name, std::shared_ptr<const Surface<Dim>> surface)
    : m_name(std::move(name)), m_surface(std::move(surface)) {
  if (m_name.empty()) fail("tool", "the name is empty");
  if (m_name.find_first_of(",\"\n\r") != std::string::npos)
    fail("tool", "name \"" + m_name + "\", expected a text without comma, quote and line break");
  if (!m_surface) fail("tool", "no surface");
}

template <int Dim>
void DrivenTool<Dim>::set_coordinates(std::shared_ptr<const Coordinates<Dim>> coordinates) {
  m_tool = std::make_shared<Tool<Dim>>(m_name, m_surface, coordinates);
  m_prescription.emplace(m_name, coordinates->names());
  m_q = m_force = Eigen::VectorXd::Zero(coordinates->size());
  const double start = 0;
  for (const auto& [name, text] : m_following) {
    move(name, text);
    place(name, m_prescription->formula(index(name))->value(&start));
  }
}

template <int Dim> const Tool<Dim>& DrivenTool<Dim>::tool() const {
  if (!m_tool) fail("tool", "\"" + m_name + "\" has no coordinates yet: call coordinates(...) first");
  return *m_tool;
}

template <int Dim> Prescription& DrivenTool<Dim>::prescription() {
  tool();
  return *m_prescription;
}

template <int Dim> void DrivenTool<Dim>::force(const std::string& coordinate, const std::string& text) {
  index(coordinate);                                            // throws
  auto& formula = m_formulas[std::make_pair(coordinate, text)]; // in braces clang 14 omits ~pair: no link
  if (!formula) formula = force_formula(m_name, coordinate, text, tool().coordinates().names(), m_parameters);
  prescription().force(coordinate, formula);
}

template <int Dim> void DrivenTool<Dim>::move(const std::string& coordinate, const std::string& text) {
  index(coordinate); // throws
  auto& formula = m_motions[{coordinate, text}];
  if (!formula) formula = motion_formula(m_name, coordinate, text, m_parameters);
  prescription().move(coordinate, formula);
}

template <int Dim>
void DrivenTool<Dim>::set_parameter(const std::string& parameter, const std::string& text) {
  const std::string where = "tool.parameter of \"" + m_name + "\"";
  check_formula_names(where, {{parameter}, {}});
  if (m_tool)
    fail(where, "\"" + parameter + "\" = " + quoted(text) +
                    " comes too late: set parameters before coordinates(...)");
  if (m_parameters.count(parameter) > 0)
    fail(where, "\"" + parameter + "\" = " + quoted(text) + ", but it is a number already");
  motion_formula(m_name, parameter, text, m_parameters); // throws
  m_following[parameter] = text;
}

template <int Dim> void DrivenTool<Dim>::set_parameter(const std::string& parameter, double value) {
  const std::string where = "tool.parameter of \"" + m_name + "\"";
  check_formula_names(where, {{}, {{parameter, value}}});
  if (m_following.count(parameter) > 0)
    fail(where, "\"" + parameter + "\" follows " + quoted(m_following.at(parameter)) + " already");
  const auto known = m_parameters.find(parameter);
  if (m_tool && known != m_parameters.end() && known->second != value) {
    std::ostringstream text;
    text << "\"" << parameter << "\" = " << value << " comes too late, it is " << known->second
         << " in formulas already: set parameters before coordinates(...)";
    fail(where, text.str());
  }
  m_parameters[parameter] = value;
}

template <int Dim> Eigen::VectorXd& DrivenTool<Dim>::q() {
  tool();
  return m_q;
}

template <int Dim> Eigen::VectorXd& DrivenTool<Dim>::generalized_force() {
  tool();
  return m_force;
}

template <int Dim> int DrivenTool<Dim>::index(const std::string& coordinate) const {
  const auto& names = tool().coordinates().names();
  std::string list;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == coordinate) return static_cast<int>(k);
    list += (k ? ", " : "") + names[k];
  }
  fail("tool", "\"" + m_name + "\" has no coordinate \"" + coordinate + "\", its coordinates are " + list);
}

template <int Dim> void DrivenTool<Dim>::place(const std::string& coordinate, double value) {
  require(std::isfinite(value), "tool.place", coordinate.c_str(), value, "a finite number");
  m_q[index(coordinate)] = value;
}

template class DrivenTool<2>;
template class DrivenTool<3>;

} // namespace burnish

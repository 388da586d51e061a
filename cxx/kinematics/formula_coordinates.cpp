#include "kinematics/formula_coordinates.hpp"
#include "base/error.hpp"
#include <sstream>

namespace burnish {
namespace {

std::vector<FormulaText> origin_of(const PlaneFormulas& formulas) {
  return {{"x", formulas.x}, {"y", formulas.y}};
}
std::vector<FormulaText> origin_of(const SpaceFormulas& formulas) {
  return {{"x", formulas.x}, {"y", formulas.y}, {"z", formulas.z}};
}
RotationFormulas<2> rotation_of(const std::string&, const PlaneFormulas& formulas,
                                const std::map<std::string, double>&) {
  return {std::make_shared<AngleRotation>(), {{"angle", formulas.angle}}};
}
RotationFormulas<3> rotation_of(const std::string& tool, const SpaceFormulas& formulas,
                                const std::map<std::string, double>& parameters) {
  return rotation_formulas("rotation of tool \"" + tool + "\"", formulas.rotation, parameters);
}

std::vector<std::string> checked(const std::string& tool, std::vector<std::string> names,
                                 const std::map<std::string, double>& parameters) {
  if (names.empty()) fail_at("coordinates of tool \"" + tool + "\"", "no names");
  check_formula_names("coordinates of tool \"" + tool + "\"", {names, parameters});
  return names;
}

} // namespace

std::vector<std::string> coordinate_names(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream items(list + ",");
  for (std::string item; std::getline(items, item, ',');) {
    const std::size_t first = item.find_first_not_of(" \t\n"), last = item.find_last_not_of(" \t\n");
    if (first == std::string::npos)
      fail("coordinates",
           "list of names " + quoted(list) + " has an empty name, expected such as \"r, phi, theta\"");
    names.push_back(item.substr(first, last - first + 1));
  }
  return names;
}

template <int Dim>
FormulaCoordinates<Dim>::FormulaCoordinates(const std::string& tool, std::vector<std::string> names,
                                            const PoseFormulas<Dim>& formulas,
                                            const std::map<std::string, double>& parameters)
    : m_names(checked(tool, std::move(names), parameters)) {
  for (const auto& formula : origin_of(formulas)) add(m_origin, tool, formula, parameters);
  const RotationFormulas<Dim> rotation = rotation_of(tool, formulas, parameters);
  m_rotation = rotation.rotation;
  for (const auto& formula : rotation.numbers) add(m_numbers, tool, formula, parameters);
  require_use(tool);
}

template <int Dim>
void FormulaCoordinates<Dim>::add(std::vector<Component>& components, const std::string& tool,
                                  const FormulaText& formula,
                                  const std::map<std::string, double>& parameters) const {
  const Formula value(formula.label + " of tool \"" + tool + "\"", formula.text, {m_names, parameters});
  Component component{formula.label, value, {}, {}};
  for (int k = 0; k < this->size(); ++k) {
    component.first.push_back(value.derivative(k));
    component.second.emplace_back();
    for (int l = 0; l <= k; ++l) component.second.back().push_back(component.first.back().derivative(l));
  }
  components.push_back(std::move(component));
}

template <int Dim> void FormulaCoordinates<Dim>::require_use(const std::string& tool) const {
  for (int k = 0; k < this->size(); ++k) {
    bool used = false;
    std::string all;
    for (const auto* components : {&m_origin, &m_numbers})
      for (const Component& component : *components) {
        used = used || component.value.depends_on(k);
        all += (all.empty() ? "" : ", ") + component.label + " = " + quoted(component.value.text());
      }
    if (!used)
      fail_at("coordinates of tool \"" + tool + "\"",
              "coordinate \"" + m_names[static_cast<std::size_t>(k)] + "\" moves nothing: " + all);
  }
}

template <int Dim> void FormulaCoordinates<Dim>::set_origin(Pose<Dim>& pose, const double* q) const {
  for (int i = 0; i < Dim; ++i) {
    const Component& x = m_origin[static_cast<std::size_t>(i)];
    pose.origin[i] = x.value(q);
    for (std::size_t k = 0; k < m_names.size(); ++k) {
      pose.origin_q[k][i] = x.first[k](q);
      for (std::size_t l = 0; l <= k; ++l)
        pose.origin_qq[k][l][i] = pose.origin_qq[l][k][i] = x.second[k][l](q);
    }
  }
}

template <int Dim> void FormulaCoordinates<Dim>::set_rotation(Pose<Dim>& pose, const double* q) const {
  const std::size_t size = m_numbers.size(), count = m_names.size();
  Eigen::VectorXd a(size);
  Eigen::MatrixXd a_q(size, count);
  for (std::size_t i = 0; i < size; ++i) {
    a(i) = m_numbers[i].value(q);
    for (std::size_t k = 0; k < count; ++k) a_q(i, k) = m_numbers[i].first[k](q);
  }
  const RotationValue<Dim> rotation = m_rotation->at(a);
  pose.R = rotation.R;
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < size; ++i) pose.R_q[k] += a_q(i, k) * rotation.first[i];
    for (std::size_t l = 0; l <= k; ++l) {
      Tensor<Dim>& R_kl = pose.R_qq[k][l];
      for (std::size_t i = 0; i < size; ++i) {
        R_kl += m_numbers[i].second[k][l](q) * rotation.first[i];
        for (std::size_t j = 0; j < size; ++j) R_kl += a_q(i, k) * a_q(j, l) * rotation.second[i][j];
      }
      pose.R_qq[l][k] = R_kl;
    }
  }
}

template <int Dim> Pose<Dim> FormulaCoordinates<Dim>::pose(const Eigen::VectorXd& q) const {
  require_coordinates("FormulaCoordinates::pose", m_names, q);
  Pose<Dim> pose = blank_pose<Dim>(this->size());
  set_origin(pose, q.data());
  set_rotation(pose, q.data());
  return pose;
}

template class FormulaCoordinates<2>;
template class FormulaCoordinates<3>;

} // namespace burnish

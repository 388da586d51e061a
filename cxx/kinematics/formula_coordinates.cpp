#include "kinematics/formula_coordinates.hpp"
#include "base/error.hpp"
#include "geometry/plane.hpp"
#include <sstream>

namespace burnish {
namespace {

Formula formula(const char* which, const std::string& tool, const std::string& text,
                const FormulaNames& names) {
  return Formula(std::string(which) + " of tool \"" + tool + "\"", text, names);
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

FormulaCoordinates::FormulaCoordinates(const std::string& tool, std::vector<std::string> names,
                                       const PlaneFormulas& formulas,
                                       const std::map<std::string, double>& parameters)
    : m_names(checked(tool, std::move(names), parameters)),
      m_x(component(formula("x", tool, formulas.x, {m_names, parameters}), size())),
      m_y(component(formula("y", tool, formulas.y, {m_names, parameters}), size())),
      m_angle(component(formula("angle", tool, formulas.angle, {m_names, parameters}), size())) {
  require_use(tool);
}

FormulaCoordinates::Component FormulaCoordinates::component(const Formula& value, int size) {
  Component result{value, {}, {}};
  for (int k = 0; k < size; ++k) {
    result.first.push_back(value.derivative(k));
    result.second.emplace_back();
    for (int l = 0; l <= k; ++l) result.second.back().push_back(result.first.back().derivative(l));
  }
  return result;
}

void FormulaCoordinates::require_use(const std::string& tool) const {
  for (int k = 0; k < size(); ++k)
    if (!m_x.value.depends_on(k) && !m_y.value.depends_on(k) && !m_angle.value.depends_on(k))
      fail_at("coordinates of tool \"" + tool + "\"",
              "coordinate \"" + m_names[static_cast<std::size_t>(k)] +
                  "\" moves nothing: x = " + quoted(m_x.value.text()) + ", y = " + quoted(m_y.value.text()) +
                  ", angle = " + quoted(m_angle.value.text()));
}

Pose<2> FormulaCoordinates::pose(const Eigen::VectorXd& q) const {
  require_coordinates("FormulaCoordinates::pose", m_names, q);
  Pose<2> pose = blank_pose<2>(size());
  pose.origin << m_x.value(q.data()), m_y.value(q.data());
  pose.R = plane_rotation(m_angle.value(q.data()));
  const Tensor<2> turned = plane_rotation_derivative(pose.R);
  for (std::size_t k = 0; k < m_names.size(); ++k) {
    pose.origin_q[k] << m_x.first[k](q.data()), m_y.first[k](q.data());
    const double angle_k = m_angle.first[k](q.data());
    pose.R_q[k] = angle_k * turned;
    for (std::size_t l = 0; l <= k; ++l) {
      pose.origin_qq[k][l] << m_x.second[k][l](q.data()), m_y.second[k][l](q.data());
      pose.R_qq[k][l] =
          m_angle.second[k][l](q.data()) * turned - angle_k * m_angle.first[l](q.data()) * pose.R;
      pose.origin_qq[l][k] = pose.origin_qq[k][l];
      pose.R_qq[l][k] = pose.R_qq[k][l];
    }
  }
  return pose;
}

} // namespace burnish

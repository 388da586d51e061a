#include "kinematics/rotation_formula.hpp"
#include "base/error.hpp"
#include "formula/formula.hpp"

namespace burnish {
namespace {

constexpr const char* BLANKS = " \t\n";

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(BLANKS), last = text.find_last_not_of(BLANKS);
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

// Parts between separators that are in no parentheses, without blanks around them.
std::vector<std::string> parts(const std::string& text, const std::string& separators) {
  std::vector<std::string> found(1);
  int depth = 0;
  for (const char c : text) {
    depth += (c == '(') - (c == ')');
    if (depth == 0 && separators.find(c) != std::string::npos)
      found.emplace_back();
    else
      found.back() += c;
  }
  for (auto& part : found) part = trimmed(part);
  return found;
}

class RotationText {
public:
  RotationText(std::string where, const std::string& text, const std::map<std::string, double>& parameters)
      : m_where(std::move(where)), m_text(trimmed(text)), m_parameters(parameters) {}

  RotationFormulas<3> read() const {
    if (m_text.empty()) return {std::make_shared<AxisRotations>(std::vector<Vector<3>>{}), {}};
    const std::vector<std::string> between = parts(m_text, ":");
    if (between.size() < 2) refuse("no axis");
    if (between[0] == "vector") return {std::make_shared<VectorRotation>(), components({"a", "b", "c"})};
    if (between[0] == "quaternion")
      return {std::make_shared<QuaternionRotation>(m_where), components({"w", "a", "b", "c"})};
    return about_axes(between);
  }

private:
  [[noreturn]] void refuse(const std::string& what) const {
    fail_at(m_where + " " + quoted(m_text),
            what + R"(, expected such as "z:phi x:theta z:psi", "[1 1 0]:phi", )" +
                R"("vector: a, b, c" or "quaternion: w, a, b, c")");
  }

  std::vector<FormulaText> components(const std::vector<std::string>& labels) const {
    const std::size_t colon = m_text.find(':');
    const std::string kind = trimmed(m_text.substr(0, colon));
    const std::vector<std::string> formulas = parts(m_text.substr(colon + 1), ",");
    if (formulas.size() != labels.size())
      refuse("a " + kind + " of " + std::to_string(formulas.size()) + " numbers");
    std::vector<FormulaText> texts;
    for (std::size_t i = 0; i < labels.size(); ++i) texts.push_back({kind + " " + labels[i], formulas[i]});
    return texts;
  }

  // Before every colon stands an axis, behind it the formula of the angle and the next axis.
  RotationFormulas<3> about_axes(const std::vector<std::string>& between) const {
    std::vector<Vector<3>> axes;
    std::vector<FormulaText> angles;
    std::string axis = between[0];
    for (std::size_t i = 1; i < between.size(); ++i) {
      axes.push_back(direction(axis));
      std::string angle = between[i], label = "rotation about " + axis;
      if (i + 1 < between.size()) {
        const std::size_t begin = last_word(angle);
        axis = angle.substr(begin);
        angle = trimmed(angle.substr(0, begin));
      }
      angles.push_back({label, angle});
    }
    return {std::make_shared<AxisRotations>(axes), angles};
  }

  static std::size_t last_word(const std::string& text) {
    const std::size_t bracket = text.rfind('[');
    if (!text.empty() && text.back() == ']' && bracket != std::string::npos) return bracket;
    return text.find_last_of(BLANKS) + 1; // npos + 1 = 0
  }

  Vector<3> direction(const std::string& axis) const {
    if (axis == "x" || axis == "y" || axis == "z") return Vector<3>::Unit(axis[0] - 'x');
    if (axis.size() < 2 || axis.front() != '[' || axis.back() != ']') refuse("unknown axis " + quoted(axis));
    std::vector<double> numbers;
    for (const auto& part : parts(axis.substr(1, axis.size() - 2), std::string(BLANKS) + ","))
      if (!part.empty())
        numbers.push_back(Formula("axis " + axis + " of " + m_where, part, {{}, m_parameters})(nullptr));
    if (numbers.size() != 3) refuse("axis " + axis + " of " + std::to_string(numbers.size()) + " numbers");
    const Vector<3> vector(numbers[0], numbers[1], numbers[2]);
    if (!(vector.norm() > 0)) refuse("axis " + axis + " of length 0");
    return vector;
  }

  std::string m_where, m_text;
  const std::map<std::string, double>& m_parameters;
};

} // namespace

RotationFormulas<3> rotation_formulas(const std::string& where, const std::string& text,
                                      const std::map<std::string, double>& parameters) {
  return RotationText(where, text, parameters).read();
}

} // namespace burnish

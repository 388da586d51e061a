#include "geometry/cad_file.hpp"
#include "base/error.hpp"
#include "geometry/cad_session.hpp"
#include "geometry/cad_text.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <gmsh.h>
#include <regex>

namespace burnish {

namespace {

constexpr const char* WHERE = "CadFile";

// What OpenCASCADE prints, in one line.
std::string one_line(const std::string& text) {
  return std::regex_replace(trimmed(text), std::regex("\\s*\n\\s*"), "; ");
}

// What gmsh must read before a .geo file: it keeps the names of the last one; numbers are taken this way.
// (Not one script with a Merge in it: gmsh 4.8.4 reads freed memory after a nested Merge.)
std::string preamble(const std::map<std::string, double>& numbers) {
  std::ostringstream script;
  script.precision(17);
  script << "Delete Variables;\n";
  for (const auto& [name, value] : numbers) script << name << " = " << value << ";\n";
  return script.str();
}
std::string epilogue(const std::map<std::string, double>& numbers) {
  std::ostringstream script;
  script.precision(17);
  for (const auto& [name, value] : numbers)
    script << "If (" << name << " != " << value << ")\n  Error(\"it gives " << name
           << " another value, %g; write DefineConstant[ " << name << " = ... ] there\", " << name
           << ");\nEndIf\n";
  script << "Delete Variables;\n";
  return script.str();
}

// Reads the file into the current model; returns the first error.
std::string read_into(const GmshSession& session, const std::string& path,
                      const std::map<std::string, double>& numbers) {
  if (file_extension(path) != ".geo") return session.merge(path);
  const TemporaryFile before(preamble(numbers), ".geo"), after(epilogue(numbers), ".geo");
  for (const std::string& file : {before.path(), path, after.path()}) {
    const std::string said = session.merge(file);
    if (!said.empty()) return said;
  }
  return "";
}

} // namespace

std::map<std::string, double> parse_numbers(const std::string& where, const std::string& text) {
  std::map<std::string, double> numbers;
  std::istringstream parts(std::regex_replace(text, std::regex(","), ";"));
  for (std::string part; std::getline(parts, part, ';');) {
    part = trimmed(part);
    if (part.empty()) continue;
    const std::size_t equal = part.find('=');
    const std::string name = trimmed(part.substr(0, equal));
    const std::string value = equal == std::string::npos ? "" : trimmed(part.substr(equal + 1));
    double number = 0;
    const auto [end, code] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (!std::regex_match(name, std::regex("[A-Za-z_][A-Za-z_0-9]*")) || code != std::errc() ||
        end != value.data() + value.size() || !std::isfinite(number))
      fail(where, "\"" + part + "\" is no number for the geometry, expected name=value; name=value");
    if (!numbers.emplace(name, number).second) fail(where, "number \"" + name + "\" is given twice");
  }
  return numbers;
}

CadFile::CadFile(std::string path, const std::map<std::string, double>& numbers) : m_path(std::move(path)) {
  check_cad_text(m_path, numbers);
  const GmshSession session;
  m_model = session.new_model();
  std::string said = read_into(session, m_path, numbers);
  gmsh::vectorpair all, exact;
  gmsh::model::getEntities(all, 1);
  gmsh::model::occ::getEntities(exact, 1);
  for (const auto& entity : all) m_curves.push_back(entity.second);
  for (const auto& entity : exact) m_exact.push_back(entity.second);
  std::sort(m_curves.begin(), m_curves.end());
  if (said.empty() && !m_curves.empty()) return;
  const std::string printed = one_line(session.printed());
  session.remove(m_model);
  if (trimmed(said) == "OpenCASCADE exception")
    said = "OpenCASCADE exception; are points of a curve closer than 1e-7, which it takes for one? Draw it "
           "larger";
  if (said.empty()) said = "no curves in it" + (printed.empty() ? "" : " (" + printed + ")");
  fail(WHERE, "\"" + m_path + "\": " + said);
}

CadFile::~CadFile() {
  const GmshSession session;
  session.remove(m_model);
}

bool CadFile::has(int dimension, int tag) const {
  const GmshSession session(m_model);
  gmsh::vectorpair all;
  gmsh::model::getEntities(all, dimension);
  return std::find(all.begin(), all.end(), std::make_pair(dimension, tag)) != all.end();
}

CadEdge CadFile::edge(int tag) const {
  const GmshSession session(m_model);
  std::vector<double> begin, end;
  CadEdge edge;
  edge.tag = tag;
  gmsh::model::getType(1, tag, edge.type);
  gmsh::model::getParametrizationBounds(1, tag, begin, end);
  if (begin.size() != 1 || end.size() != 1 || !(begin[0] < end[0]))
    fail(WHERE, "\"" + m_path + "\": curve " + std::to_string(tag) + " (" + edge.type +
                    ") has no range of its parameter: its points are not finite or fall together");
  edge.begin = begin[0];
  edge.end = end[0];
  edge.exact_derivative = std::find(m_exact.begin(), m_exact.end(), tag) != m_exact.end();
  return edge;
}

Eigen::Matrix3Xd CadFile::value(int tag, const std::vector<double>& u) const {
  const GmshSession session(m_model);
  std::vector<double> x;
  gmsh::model::getValue(1, tag, u, x);
  return Eigen::Map<Eigen::Matrix3Xd>(x.data(), 3, static_cast<Eigen::Index>(x.size() / 3));
}

Eigen::Matrix3Xd CadFile::derivative(int tag, const std::vector<double>& u) const {
  const GmshSession session(m_model);
  std::vector<double> x;
  gmsh::model::getDerivative(1, tag, u, x);
  return Eigen::Map<Eigen::Matrix3Xd>(x.data(), 3, static_cast<Eigen::Index>(x.size() / 3));
}

} // namespace burnish

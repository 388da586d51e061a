#include "kinematics/drive.hpp"
#include "base/error.hpp"
#include "kinematics/coordinates.hpp"
#include <algorithm>
#include <cmath>
#include <utility>

namespace burnish {

Drive::Drive(std::string tool, std::vector<std::string> names)
    : m_tool(std::move(tool)), m_names(std::move(names)), m_prescriptions(m_names.size()) {
  if (m_names.empty()) fail("Drive", "tool \"" + m_tool + "\" has no coordinates");
  for (auto name = m_names.begin(); name != m_names.end(); ++name) {
    if (name->empty()) fail("Drive", "tool \"" + m_tool + "\" has a coordinate with an empty name");
    if (std::find(m_names.begin(), name, *name) != name)
      fail("Drive", "tool \"" + m_tool + "\" has two coordinates \"" + *name + "\"");
  }
}

void Drive::move(const std::string& name, double value) { set("Drive::move", name, Kind::MOTION, value); }

void Drive::load(const std::string& name, double value) { set("Drive::load", name, Kind::FORCE, value); }

bool Drive::is_set(int k) const { return at("Drive::is_set", k).kind != Kind::NONE; }

bool Drive::is_motion(int k) const { return prescribed("Drive::is_motion", k).kind == Kind::MOTION; }

double Drive::value(int k) const { return prescribed("Drive::value", k).value; }

void Drive::check_complete() const {
  std::string message;
  for (std::size_t k = 0; k < m_names.size(); ++k)
    if (m_prescriptions[k].kind == Kind::NONE) message += (message.empty() ? "" : "; ") + missing(k);
  if (!message.empty()) fail("Drive", message);
}

void Drive::set(const char* where, const std::string& name, Kind kind, double value) {
  const auto found = std::find(m_names.begin(), m_names.end(), name);
  if (found == m_names.end())
    fail(where,
         "tool \"" + m_tool + "\" has no coordinate \"" + name + "\", expected one of " + joined(m_names));
  const std::string what = "value of \"" + name + "\" of tool \"" + m_tool + "\"";
  require(std::isfinite(value), where, what.c_str(), value, "a finite number");
  m_prescriptions[static_cast<std::size_t>(found - m_names.begin())] = {kind, value};
}

const Drive::Prescription& Drive::at(const char* where, int k) const {
  const std::string expected = "0 <= k < " + std::to_string(size()) + " (" + joined(m_names) + ")";
  require(k >= 0 && k < size(), where, "k", k, expected.c_str());
  return m_prescriptions[static_cast<std::size_t>(k)];
}

const Drive::Prescription& Drive::prescribed(const char* where, int k) const {
  const Prescription& prescription = at(where, k);
  if (prescription.kind == Kind::NONE) fail(where, missing(static_cast<std::size_t>(k)));
  return prescription;
}

std::string Drive::missing(std::size_t k) const {
  return "coordinate \"" + m_names[k] + "\" of tool \"" + m_tool + "\" has neither motion nor force";
}

} // namespace burnish

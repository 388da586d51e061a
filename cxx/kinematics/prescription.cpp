#include "kinematics/prescription.hpp"
#include "base/error.hpp"
#include "kinematics/coordinates.hpp"
#include <algorithm>
#include <cmath>
#include <utility>

namespace burnish {

Prescription::Prescription(std::string tool, std::vector<std::string> names)
    : m_tool(std::move(tool)), m_names(std::move(names)), m_entries(m_names.size()) {
  if (m_names.empty()) fail("Prescription", "tool \"" + m_tool + "\" has no coordinates");
  for (auto name = m_names.begin(); name != m_names.end(); ++name) {
    if (name->empty()) fail("Prescription", "tool \"" + m_tool + "\" has a coordinate with an empty name");
    if (std::find(m_names.begin(), name, *name) != name)
      fail("Prescription", "tool \"" + m_tool + "\" has two coordinates \"" + *name + "\"");
  }
}

void Prescription::move(const std::string& name, double value) {
  set("Prescription::move", name, {Kind::MOTION, value});
}

void Prescription::move(const std::string& name, std::shared_ptr<const CoordinateFormula> formula) {
  set("Prescription::move", name, {Kind::MOTION, 0, std::move(formula)});
}

void Prescription::force(const std::string& name, double value) {
  set("Prescription::force", name, {Kind::FORCE, value});
}

void Prescription::force(const std::string& name, std::shared_ptr<const CoordinateFormula> formula) {
  set("Prescription::force", name, {Kind::FORCE, 0, std::move(formula)});
}

void Prescription::follow(const std::string& name, const std::string& relation) {
  Entry& found = entry("couple", name);
  if (found.kind == Kind::FOLLOWS)
    fail("couple", "coordinate \"" + name + "\" of tool \"" + m_tool + "\" follows " +
                       quoted(found.relation) + " already");
  if (found.kind != Kind::NONE)
    fail("couple", "coordinate \"" + name + "\" of tool \"" + m_tool + "\" has a " +
                       (found.kind == Kind::MOTION ? "motion" : "force") + " already and cannot follow " +
                       quoted(relation) + " as well: it takes neither motion nor force of its own");
  found = {Kind::FOLLOWS, 0, nullptr, relation};
}

void Prescription::set_entries(const std::vector<Entry>& entries) {
  require(entries.size() == m_entries.size(), "Prescription::set_entries", "number of entries",
          entries.size(), std::to_string(m_entries.size()).c_str());
  m_entries = entries;
}

bool Prescription::follows(int k) const { return at("Prescription::follows", k).kind == Kind::FOLLOWS; }

std::shared_ptr<const CoordinateFormula> Prescription::formula(int k) const {
  return prescribed("Prescription::formula", k).formula;
}

bool Prescription::is_set(int k) const { return at("Prescription::is_set", k).kind != Kind::NONE; }

bool Prescription::is_motion(int k) const {
  return prescribed("Prescription::is_motion", k).kind == Kind::MOTION;
}

double Prescription::value(int k) const { return prescribed("Prescription::value", k).value; }

void Prescription::check_complete() const {
  std::string message;
  for (std::size_t k = 0; k < m_names.size(); ++k)
    if (m_entries[k].kind == Kind::NONE) message += (message.empty() ? "" : "; ") + missing(k);
  if (!message.empty()) fail("Prescription", message);
}

Prescription::Entry& Prescription::entry(const char* where, const std::string& name) {
  const auto found = std::find(m_names.begin(), m_names.end(), name);
  if (found == m_names.end())
    fail(where,
         "tool \"" + m_tool + "\" has no coordinate \"" + name + "\", expected one of " + joined(m_names));
  return m_entries[static_cast<std::size_t>(found - m_names.begin())];
}

void Prescription::set(const char* where, const std::string& name, Entry given) {
  Entry& old = entry(where, name);
  const std::string what = "value of \"" + name + "\" of tool \"" + m_tool + "\"";
  require(std::isfinite(given.value), where, what.c_str(), given.value, "a finite number");
  if (old.kind == Kind::FOLLOWS)
    fail(where, "coordinate \"" + name + "\" of tool \"" + m_tool + "\" follows " + quoted(old.relation) +
                    " and takes neither motion nor force of its own: prescribe what it follows");
  old = std::move(given);
}

const Prescription::Entry& Prescription::at(const char* where, int k) const {
  const std::string expected = "0 <= k < " + std::to_string(size()) + " (" + joined(m_names) + ")";
  require(k >= 0 && k < size(), where, "k", k, expected.c_str());
  return m_entries[static_cast<std::size_t>(k)];
}

const Prescription::Entry& Prescription::prescribed(const char* where, int k) const {
  const Entry& entry = at(where, k);
  if (entry.kind == Kind::NONE) fail(where, missing(static_cast<std::size_t>(k)));
  return entry;
}

std::string Prescription::missing(std::size_t k) const {
  return "coordinate \"" + m_names[k] + "\" of tool \"" + m_tool + "\" has neither motion nor force";
}

} // namespace burnish

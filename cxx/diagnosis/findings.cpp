#include "diagnosis/findings.hpp"
#include <algorithm>

namespace burnish {

const char* name_of(Severity severity) {
  switch (severity) {
  case Severity::NOTE:
    return "note";
  case Severity::WARNING:
    return "warning";
  case Severity::UNTRUSTED:
    return "untrusted";
  case Severity::STOP:
    break;
  }
  return "stop";
}

Finding* FindingList::report(const std::string& check, const std::string& subject, Severity severity,
                             double excess, double t) {
  for (Finding& known : m_list) {
    if (known.check != check || known.subject != subject) continue;
    ++known.count;
    if (severity < known.severity || (severity == known.severity && !(excess > known.excess))) return nullptr;
    known.severity = severity;
    known.excess = excess;
    known.t = t;
    return &known;
  }
  Finding finding;
  finding.check = check;
  finding.subject = subject;
  finding.severity = severity;
  finding.excess = excess;
  finding.t = finding.first = t;
  finding.count = 1;
  m_list.push_back(std::move(finding));
  return &m_list.back();
}

Finding* FindingList::beyond(const std::string& check, const std::string& subject, double value,
                             const Bounds& bounds, double t) {
  if (!(value > bounds.noted)) return nullptr;
  const bool far = value > bounds.far;
  Finding* finding = report(check, subject, far ? Severity::UNTRUSTED : Severity::WARNING, value, t);
  if (!finding) return nullptr;
  finding->value = value;
  finding->bound = far ? bounds.far : bounds.noted;
  return finding;
}

bool FindingList::holds(const std::string& check, const std::string& subject) const {
  return std::any_of(m_list.begin(), m_list.end(),
                     [&](const Finding& known) { return known.check == check && known.subject == subject; });
}

void FindingList::largest(const std::string& name, double value) {
  const auto entry = m_measured.emplace(name, value).first;
  entry->second = std::max(entry->second, value);
}

void FindingList::smallest(const std::string& name, double value) {
  const auto entry = m_measured.emplace(name, value).first;
  entry->second = std::min(entry->second, value);
}

void FindingList::withdraw(const std::string& check, const std::string& subject) {
  m_list.erase(
      std::remove_if(m_list.begin(), m_list.end(),
                     [&](const Finding& known) { return known.check == check && known.subject == subject; }),
      m_list.end());
}

const Finding* FindingList::worst() const {
  const Finding* worst = nullptr;
  for (const Finding& finding : m_list)
    if (!worst || finding.severity > worst->severity) worst = &finding;
  return worst;
}

bool FindingList::trusted() const {
  const Finding* finding = worst();
  return !finding || finding->severity < Severity::UNTRUSTED;
}

} // namespace burnish

#include "diagnosis/diagnosis.hpp"
#include "base/cpu_time.hpp"
#include "diagnosis/observers.hpp"
#include <algorithm>

namespace burnish {

template <int Dim> Diagnosis<Dim>::Diagnosis(const Diagnosis& other) { *this = other; }

template <int Dim> Diagnosis<Dim>& Diagnosis<Dim>::operator=(const Diagnosis& other) {
  if (this == &other) return *this;
  m_observers.clear();
  for (const auto& observer : other.m_observers) m_observers.push_back(observer->clone());
  m_always = other.m_always;
  m_findings = other.m_findings;
  m_checks = other.m_checks;
  m_begun = other.m_begun;
  m_steps = other.m_steps;
  m_seconds = other.m_seconds;
  return *this;
}

template <int Dim> void Diagnosis<Dim>::restart() {
  m_observers = causes<Dim>();
  m_always = m_observers.size();
  for (auto& check : checks<Dim>()) m_observers.push_back(std::move(check));
  m_findings.forget_measured();
  m_begun = false;
  m_steps = 0;
}

template <int Dim> void Diagnosis<Dim>::begin(AcceptedStep<Dim> step) {
  if (m_begun) return;
  double unchecked = 0;
  const CpuTimer timer(m_checks ? m_seconds : unchecked);
  prepare(step, 0, m_checks);
  const std::size_t looking = m_checks ? m_observers.size() : m_always;
  for (std::size_t i = 0; i < looking; ++i) m_observers[i]->begin(step, m_findings);
  m_begun = true;
}

template <int Dim> std::string Diagnosis<Dim>::look(AcceptedStep<Dim> step) {
  if (!m_begun) return "";
  double unchecked = 0;
  const CpuTimer timer(m_checks ? m_seconds : unchecked);
  prepare(step, ++m_steps, m_checks);
  const std::size_t looking = m_checks ? m_observers.size() : m_always;
  for (std::size_t i = 0; i < looking; ++i) m_observers[i]->look(step, m_findings);
  for (const Finding& finding : m_findings.list())
    if (finding.severity == Severity::STOP && finding.t == step.t) return finding.text;
  return "";
}

template <int Dim> std::vector<Failure> Diagnosis<Dim>::explain(const FailedStep<Dim>& step) const {
  std::vector<Failure> found;
  for (const auto& observer : m_observers) observer->explain(step, found);
  return found;
}

template <int Dim>
std::vector<Statement> Diagnosis<Dim>::report(const AcceptedStep<Dim>& step,
                                              const StepAccuracy& accuracy) const {
  constexpr std::size_t most = 10;
  std::vector<Statement> list;
  if (m_steps == 0 || !m_checks || !step.workpiece) return list;
  for (const auto& observer : m_observers) observer->end({step, m_findings, accuracy}, list);
  std::stable_sort(list.begin(), list.end(),
                   [](const Statement& a, const Statement& b) { return a.importance > b.importance; });
  if (list.size() > most) list.resize(most);
  return list;
}

namespace {

template <int Dim> void pass(Writer& archive, const Observer<Dim>& observer) { observer.save(archive); }
template <int Dim> void pass(Reader& archive, Observer<Dim>& observer) { observer.load(archive); }

} // namespace

// The list of observers is that of the program: only what they remember is passed.
template <int Dim> template <class Archive> void Diagnosis<Dim>::remember(Archive& archive) {
  auto& [observers, always, findings, checks, begun, steps, seconds] = *this;
  archive(always, findings, checks, begun, steps, seconds);
  for (auto& observer : observers) pass(archive, *observer);
}

template <int Dim> void Diagnosis<Dim>::save(Writer& archive) const {
  const_cast<Diagnosis&>(*this).remember(archive);
}
template <int Dim> void Diagnosis<Dim>::load(Reader& archive) { remember(archive); }

template class Diagnosis<2>;
template class Diagnosis<3>;

} // namespace burnish

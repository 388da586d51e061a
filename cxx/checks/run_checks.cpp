#include "checks/run_checks.hpp"
#include "base/cpu_time.hpp"
#include "checks/balance_check.hpp"
#include "checks/contact_check.hpp"
#include "checks/deformation_check.hpp"
#include "checks/energy_check.hpp"
#include "checks/folding_check.hpp"
#include "checks/locking_check.hpp"
#include "checks/overlap_check.hpp"
#include "checks/pressure_check.hpp"
#include "checks/tool_overlap_check.hpp"
#include "checks/yield_check.hpp"

namespace burnish {

template <int Dim> RunChecks<Dim>::RunChecks() {
  m_checks.push_back(std::make_unique<BalanceCheck<Dim>>());
  m_checks.push_back(std::make_unique<ContactCheck<Dim>>());
  m_checks.push_back(std::make_unique<PressureCheck<Dim>>());
  m_checks.push_back(std::make_unique<OverlapCheck<Dim>>());
  m_checks.push_back(std::make_unique<ToolOverlapCheck<Dim>>());
  m_checks.push_back(std::make_unique<FoldingCheck<Dim>>());
  m_checks.push_back(std::make_unique<DeformationCheck<Dim>>());
  m_checks.push_back(std::make_unique<YieldCheck<Dim>>());
  m_checks.push_back(std::make_unique<LockingCheck<Dim>>());
  m_checks.push_back(std::make_unique<EnergyCheck<Dim>>());
}
template <int Dim> RunChecks<Dim>::~RunChecks() = default;

template <int Dim> void RunChecks<Dim>::begin(AcceptedStep<Dim> step) {
  const CpuTimer timer(m_seconds);
  prepare(step);
  for (const auto& check : m_checks) check->begin(step, m_state);
  m_state.begun = true;
}

template <int Dim> void RunChecks<Dim>::look(AcceptedStep<Dim>& step, FindingList& findings) {
  const CpuTimer timer(m_seconds);
  prepare(step);
  ++m_state.steps;
  for (const auto& check : m_checks) check->look(step, m_options, m_state, findings);
}

template class RunChecks<2>;
template class RunChecks<3>;

} // namespace burnish

#pragma once
// Work done on the workpiece against what it stores and dissipates (METHOD.md 3.17).
#include "checks/run_checks.hpp"

namespace burnish {

template <int Dim> class EnergyCheck final : public Check<Dim> {
public:
  void begin(const AcceptedStep<Dim>& step, CheckState& state) override;
  void look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
            FindingList& findings) override;
};

} // namespace burnish

#pragma once
// Forces and moments on the workpiece (ALGORITHMS.md 16.1).
#include "checks/run_checks.hpp"

namespace burnish {

template <int Dim> class BalanceCheck final : public Check<Dim> {
public:
  void look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
            FindingList& findings) override;
};

} // namespace burnish

#pragma once
// Reported pressures against the nodal forces that they stand for (ALGORITHMS.md 16.2).
#include "checks/run_checks.hpp"

namespace burnish {

/// Of quadratic elements; pressures of linear ones are nodal forces over areas, which add up by themselves.
template <int Dim> class PressureCheck final : public Check<Dim> {
public:
  void look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
            FindingList& findings) override;
};

} // namespace burnish

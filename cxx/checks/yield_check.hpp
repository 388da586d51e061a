#pragma once
// Stress beyond the yield surface, and volume that plastic flow changed (ALGORITHMS.md 16.5).
#include "checks/run_checks.hpp"

namespace burnish {

template <int Dim> class YieldCheck final : public Check<Dim> {
public:
  void look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
            FindingList& findings) override;

private:
  void look_at_volume(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                      FindingList& findings) const;
};

} // namespace burnish

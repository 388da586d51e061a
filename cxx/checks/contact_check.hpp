#pragma once
// What a contact must fulfill: no tension, friction within its limit and against the slip, more than a few nodes
// (ALGORITHMS.md 16.2).
#include "checks/run_checks.hpp"

namespace burnish {

template <int Dim> class ContactCheck final : public Check<Dim> {
public:
  void look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
            FindingList& findings) override;

private:
  void look_at_forces(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                      FindingList& findings) const;
  void look_at_width(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                     FindingList& findings) const;
};

} // namespace burnish

#pragma once
// Range of the law and distortion of the elements (ALGORITHMS.md 16.4).
#include "checks/run_checks.hpp"

namespace burnish {

template <int Dim> class DeformationCheck final : public Check<Dim> {
public:
  void look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
            FindingList& findings) override;

private:
  void look_at_strain(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                      FindingList& findings) const;
  void look_at_elements(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                        FindingList& findings);
  void look_at_shapes(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                      FindingList& findings);

  std::vector<double> m_quality; // of the undeformed elements
};

} // namespace burnish

#pragma once
// Linear elements that lock: the mean stress alternates from element to element (ALGORITHMS.md 16.6).
#include "checks/run_checks.hpp"

namespace burnish {

template <int Dim> class LockingCheck final : public Check<Dim> {
public:
  void look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
            FindingList& findings) override;

private:
  void find_neighbors(const Mesh<Dim>& mesh);
  /// Jumps of the mean stress over the von Mises stress, of plastic elements or of all; 0 where none can tell [-].
  double alternation(const AcceptedStep<Dim>& step, bool everywhere) const;
  std::vector<int> m_neighbor; ///< per element and vertex: across the opposite face, -1: none
};

} // namespace burnish

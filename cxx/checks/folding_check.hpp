#pragma once
// The workpiece in itself: boundary edges that cross (ALGORITHMS.md 16.3).
#include "checks/boundary_edges.hpp"
#include "checks/run_checks.hpp"

namespace burnish {

/// Of the plane; in space nothing is checked.
template <int Dim> class FoldingCheck final : public Check<Dim> {
public:
  void look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
            FindingList& findings) override;

private:
  void look_at_plane(const AcceptedStep<2>& step, CheckState& state, FindingList& findings);
  std::vector<BoundaryEdge> m_edges;
};

} // namespace burnish

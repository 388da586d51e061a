#pragma once
// Tools that pass through each other (ALGORITHMS.md 16.3).
#include "checks/run_checks.hpp"
#include "checks/tool_overlap.hpp"

namespace burnish {

/// Of the plane; in space nothing is checked.
template <int Dim> class ToolOverlapCheck final : public Check<Dim> {
public:
  void begin(const AcceptedStep<Dim>& step, CheckState& state) override;
  void look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
            FindingList& findings) override;

private:
  struct Outline {
    std::vector<SurfacePlace<2>> places;
    double spacing = 0; ///< bound of the way along the surface between neighbors [length]
    double reach = 0;   ///< largest distance of its points from its origin [length]
  };
  void measure(const AcceptedStep<2>& step);
  double motion(const AcceptedStep<2>& step, int a, int b, ToolPairState& pair) const;
  ToolOverlap overlap(const AcceptedStep<2>& step, int a, int b) const;
  void look_at_pair(const AcceptedStep<2>& step, int a, int b, double bound, ToolPairState& pair,
                    CheckState& state, FindingList& findings) const;

  std::vector<Outline> m_outlines;
};

} // namespace burnish

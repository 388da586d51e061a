#pragma once
// Tools in the workpiece: between the nodes of an edge, and at edges that no label lets them touch (ALGORITHMS.md 16.3).
#include "checks/boundary_edges.hpp"
#include "checks/run_checks.hpp"
#include "checks/tool_depth.hpp"

namespace burnish {

/// Of the plane; in space nothing is checked.
template <int Dim> class OverlapCheck final : public Check<Dim> {
public:
  void look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
            FindingList& findings) override;

private:
  /// A node that is far from a tool is not asked again before both could have met.
  struct Distance {
    double known = -1; ///< when it was asked last; < 0: never [length]
    Vector<2> x = Vector<2>::Zero();
    double moved = 0; ///< of the tool until then
    Param<2> hint = Param<2>::Zero();
  };
  struct Watched {
    Vector<2> origin;
    Tensor<2> R;
    double reach = 0;               ///< largest distance of its points from its origin [length]
    double moved = 0;               ///< way that no point of it has exceeded so far [length]
    std::vector<Distance> distance; ///< per node of the boundary
  };
  void start(const AcceptedStep<2>& step);
  void move(const AcceptedStep<2>& step, int tool);
  double distance(const AcceptedStep<2>& step, int tool, int node);
  void look_at_tool(const AcceptedStep<2>& step, const CheckOptions& options, CheckState& state,
                    FindingList& findings, int tool);

  std::vector<BoundaryEdge> m_edges;
  std::vector<int> m_place;     // of a node among those of the boundary
  std::vector<int> m_candidate; // of a node, -1: none
  std::vector<Watched> m_tools;
};

} // namespace burnish

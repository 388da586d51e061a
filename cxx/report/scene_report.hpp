#pragma once
// Looks at every accepted step for what the scene models in vain and what it lacks (ALGORITHMS.md 17). Called by the
// Stepper beside the self-checks; it moves nothing.
#include "checks/accepted_step.hpp"
#include "report/mirror.hpp"
#include "report/report_options.hpp"
#include "report/scene_state.hpp"
#include <memory>

namespace burnish {

template <int Dim> class SceneReport {
public:
  ReportOptions& options() { return m_options; }
  const ReportOptions& options() const { return m_options; }
  /// @param step prepared
  void look(const AcceptedStep<Dim>& step);
  const SceneState& state() const { return m_state; }
  void set_state(const SceneState& state) { m_state = state; }
  double seconds() const { return m_seconds; } ///< CPU of all looks [s]

private:
  void look_at_tools(const AcceptedStep<Dim>& step);
  void look_at_friction(const AcceptedStep<Dim>& step, int tool, double largest);
  void look_at_ends(const AcceptedStep<Dim>& step, int tool, double load);
  void look_at_coordinates(const AcceptedStep<Dim>& step);
  void look_at_points(const AcceptedStep<Dim>& step, double load);
  void look_at_symmetry(const AcceptedStep<Dim>& step);
  bool touches_both_halves(const AcceptedStep<Dim>& step, int axis);
  void find_ends(const AcceptedStep<Dim>& step);

  ReportOptions m_options;
  SceneState m_state;
  // made from the mesh, once
  bool m_begun = false;
  std::vector<char> m_end; // per candidate: the last one of an open contact surface, and not held
  double m_size = 0;
  Vector<Dim> m_middle = Vector<Dim>::Zero();
  std::vector<std::unique_ptr<Mirror<Dim>>> m_mirror; // per axis
  std::unique_ptr<MeshLocator<Dim>> m_locator;
  double m_seconds = 0;
};

} // namespace burnish

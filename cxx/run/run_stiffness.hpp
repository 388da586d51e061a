#pragma once
// Stiffness of the tools of a run at its accepted state (METHOD.md 3.22).
#include "contact/tool_stiffness.hpp"
#include "run/contact_run.hpp"
#include "workpiece/workpiece.hpp"

namespace burnish {

template <int Dim> class RunStiffness {
public:
  /// @param where called by, for its errors; @param run must outlive it
  RunStiffness(const char* where, ContactRun<Dim>& run)
      : m_where(where), m_run(run), m_stiffness(run.setup().model(), run.setup().body()) {}
  /// Place of a coordinate in q. @throws std::invalid_argument "where: ..." if the tool has no such coordinate, or if it
  /// follows others: it has no force of its own
  int coordinate(const DrivenTool<Dim>& tool, const std::string& name) const;
  /// @throws std::invalid_argument "where: ..." before the first accepted step, and within a step
  void require_accepted() const;
  /// dQ/dq of all coordinates at the accepted state, driven as in its step, see driven_stiffness.
  /// @param K tangent of the body at the accepted state [force/length]; that of a soft hold is added here
  /// @throws std::invalid_argument "where: ..." as require_accepted, and if K has another size
  Eigen::MatrixXd driven(const NodeBlockMatrix<Dim>& K);
  /// The same with the rate tangent of the workpiece, for a step that goes on like the last one.
  /// @param elastic elastic moduli everywhere: the tools turn back
  /// @throws std::invalid_argument the same, and for a user-defined law: it has no rate tangent of its own
  Eigen::MatrixXd driven(const Workpiece<Dim>& workpiece, bool elastic);

private:
  const char* m_where;
  ContactRun<Dim>& m_run;
  ToolStiffness<Dim> m_stiffness;
  NodeBlockMatrix<Dim> m_K;
};

} // namespace burnish

#pragma once
// The deformable body: quadrature-point state at the start and at the end of a step, internal force, tangent.
// Knows no tool, and of its material only that it is a law. A step can always be repeated: `accept` and
// `revert` are the only ways between the states.
#include "workpiece/assembly.hpp"
#include "workpiece/axis.hpp"
#include "workpiece/element_division.hpp"
#include "workpiece/integrity_changes.hpp"
#include "workpiece/user_points.hpp"
#include <memory>
#include <optional>

namespace burnish {

struct UpdateResult {
  UpdateStatus status = UpdateStatus::OK;
  int point = -1; ///< first point concerned
  double value =
      0; ///< determinant(F) (or of F_mid = (F_old + F)/2) that is not > 0, or not finite, there; see
         ///< PointResult
};

template <int Dim> class Workpiece {
public:
  /// Undeformed and free of stress.
  /// @throws std::invalid_argument if the arrays of the discretization do not fit together, there is no law, or an
  ///         option is outside its range
  Workpiece(Discretization<Dim> discretization, std::shared_ptr<const MaterialLaw<Dim>> law,
            UpdateOptions options = {});
  const Discretization<Dim>& discretization() const { return m_discretization; }
  const MaterialLaw<Dim>& law() const { return *m_law; }
  std::shared_ptr<const MaterialLaw<Dim>> shared_law() const { return m_law; }
  const WorkpieceState<Dim>& state_old() const { return m_state_old; }
  const WorkpieceState<Dim>& state() const { return m_state; }
  /// To be changed between steps only.
  UpdateOptions& options() { return m_options; }
  const UpdateOptions& options() const { return m_options; }

  /// Stress at the end of a step that leads from state_old to `displacement`: writes state(). Depends on
  /// state_old only (and on the numbers of substeps, which iteration 0 resets). Where the status is not OK,
  /// state() is unusable until the next update or revert.
  /// @param displacement total displacement, num_dofs [length]; @param dt step length > 0 [time]
  /// @param iteration    0,1,2.. within the step; a point's number of substeps may only grow before
  ///                     FREEZE_ITERATION and is frozen from there on (a point that yields later gets one
  ///                     then)
  /// @throws std::invalid_argument if the size, dt, iteration or an option is wrong, or where axisymmetric a
  ///         node on the axis has u_r other than 0 but for rounding (names it): the solver must constrain it
  UpdateResult update(const Eigen::VectorXd& displacement, double dt, int iteration);
  /// Internal force of state(): sum over points V0 P grad_X N, P = tau F^-T, and where axisymmetric V0 P_zz
  /// N/R on the radial dof, the force of the whole ring; num_dofs [force].
  Eigen::VectorXd internal_force() const;
  /// Its tangent (symmetric part), into a matrix with this discretization's pattern: replaces the values, or makes them.
  /// Right after accept, revert or set_state the increment is zero and CONSISTENT means RATE, its limit for a
  /// step that goes on like the last one. RATE: a point loads if it flowed in the last update.
  /// @param elastic_blend 0..1: part of elastic moduli in plastic points (ALGORITHMS.md 5.2)
  /// @throws std::invalid_argument if the pattern is another one or elastic_blend is out of range
  void tangent(NodeBlockMatrix<Dim>& matrix, TangentKind kind, double elastic_blend = 0) const;
  /// Adds what tangent() leaves out, the antisymmetric part of the derivative of the force.
  /// @param matrix with values; other parameters and errors as those of tangent()
  void add_antisymmetric_tangent(NodeBlockMatrix<Dim>& matrix, TangentKind kind,
                                 double elastic_blend = 0) const;
  /// Matrix without values, for tangent() to fill.
  NodeBlockMatrix<Dim> pattern() const { return m_assembly.pattern(); }
  /// Moduli A = dP/dF at a point, symmetrized, rows and columns in the order of Gradient: what forms written in a script
  /// need [stress].
  /// @throws std::invalid_argument if point or elastic_blend is out of range
  PiolaTangent<Dim> point_moduli(int point, TangentKind kind, double elastic_blend = 0) const;

  /// From now on (true) the stress of each update and the moduli of each tangent are given from outside, by a user-defined
  /// law; update then moves the points only. Always so with a law without moduli.
  /// @throws std::invalid_argument for false with such a law
  void set_user_defined(bool user_defined);
  bool user_defined() const { return m_user.has_value(); }
  /// Takes what it gives for state().
  /// @throws std::invalid_argument "where: ..." if the law is not user-defined, or no update came before
  GivenPoints<Dim> given(const char* where);

  /// From now on every point has an integrity, 1 at first (METHOD.md 1.12); without this call none costs anything.
  void track_integrity();
  /// Between steps: from the next step on the integrity of a point goes to `goal` in equal parts of `steps` full steps,
  /// in place of any change under way. @param goal 0 < goal <= 1 [-]; @param steps >= 1
  /// @throws std::invalid_argument if out of range, without track_integrity, or if it grows with a user-defined law, whose
  ///         stress the core cannot forget
  void change_integrity(int point, double goal, int steps);
  /// Length of a full step [time], for updates of parts of it: they change integrities by their share. 0: every update
  /// is a full step. @throws std::invalid_argument if < 0 or not finite
  void set_step_length(double length) { m_integrity.set_step_length(length); }

  void accept(); ///< state_old = state
  void revert(); ///< state = state_old
  /// Whether a point starts the next step on the yield surface, in both states: what an element event decides, see
  /// accept_events. @throws std::invalid_argument if point is out of range
  void set_plastic(int point, bool plastic);
  /// Replaces both states (resume, copies).
  /// @throws std::invalid_argument on wrong sizes, numbers that are not finite, or det F <= 0; nothing has
  /// changed then
  void set_state(const WorkpieceState<Dim>& state);

  /// The step of a point from state_old(), as healing leaves it (METHOD.md 1.12), to state().
  PointStep<Dim> point_step(int point) const;

private:
  double step_ratio() const;
  bool tracks_integrity() const { return m_state_old.tracks_integrity(); }
  const WorkpieceState<Dim>& start() const {
    return m_updated ? m_integrity.start(m_state_old) : m_state_old;
  }
  UpdateResult deform(int first_element, int end_element);
  UpdateResult update_batch(int first_element, int end_element, int iteration);
  UpdateResult update_elements(int iteration);
  UpdateResult update_points(int first, int end, int iteration);
  PiolaTangent<Dim> moduli(int point, TangentKind kind, double elastic_blend) const;
  PiolaTangent<Dim> exact_moduli(int point, TangentKind kind, double elastic_blend) const;
  double own_blend(int point) const;
  void require_point(const char* where, int point) const;

  Discretization<Dim> m_discretization;
  std::shared_ptr<const MaterialLaw<Dim>> m_law;
  UpdateOptions m_options;
  TangentAssembly<Dim> m_assembly;
  ElementDivision<Dim> m_division;
  AxisNodes<Dim> m_axis;
  WorkpieceState<Dim> m_state_old, m_state;
  std::vector<PointTrial> m_trial; // per point, this step
  std::vector<int>
      m_switches; // per point: how often this step's updates have made it plastic or elastic again
  std::optional<UserPoints<Dim>> m_user;
  IntegrityChanges<Dim> m_integrity;
  bool m_updated = false; // state() comes from update, not from accept, revert, set_state
};

} // namespace burnish

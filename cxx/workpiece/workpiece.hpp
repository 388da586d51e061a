#pragma once
// The deformable body: quadrature-point state at the start and at the end of a step, internal force, tangent.
// Knows no tool, and of its material only that it is a law. A step can always be repeated: `accept` and
// `revert` are the only ways between the states.
#include "workpiece/assembly.hpp"
#include "workpiece/axis.hpp"
#include "workpiece/user_points.hpp"
#include "workpiece/workpiece_state.hpp"
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
  /// Matrix without values, for tangent() to fill.
  NodeBlockMatrix<Dim> pattern() const { return m_assembly.pattern(); }
  /// Moduli A = dP/dF at a point, symmetrized, rows and columns in the order of Gradient, and first Piola stress P in
  /// the same order: what forms written in a script need [stress].
  /// @throws std::invalid_argument if point or elastic_blend is out of range
  PiolaTangent<Dim> point_moduli(int point, TangentKind kind, double elastic_blend = 0) const;
  Gradient<Dim> point_piola(int point) const;

  /// From now on (true) the stress of each update and the moduli of each tangent are given from outside, by a user-defined
  /// law; update then moves the points only. Always so with a law without moduli.
  /// @throws std::invalid_argument for false with such a law, for true if integrities are tracked
  void set_user_defined(bool user_defined);
  bool user_defined() const { return m_user.has_value(); }
  /// What it gives for state(), see UserPoints; `internal` by the name of the variable. plastic_strain_eq that has grown
  /// in the step makes a point a plastic one.
  /// @throws std::invalid_argument "where: ..." also where the law is not user-defined, or no update came before
  using PointValues = typename UserPoints<Dim>::Values;
  void give_stress(int component, const PointValues& values, const char* where);
  void give_piola(int component, const PointValues& values, const char* where);
  void give_moduli(int row, int column, const PointValues& values, const char* where);
  void give_jacobian(int row, int column, const PointValues& values, const char* where);
  void give_internal(const std::string& name, int component, const PointValues& values, const char* where);

  /// From now on every point has an integrity, 1 at first (METHOD.md 1.12); without this call none costs anything.
  /// @throws std::invalid_argument if the law is user-defined: the core cannot forget a stress that a script keeps
  void track_integrity();
  bool tracks_integrity() const { return !m_state_old.integrity.empty(); }
  /// Between steps: from the next step on the integrity of a point goes to `goal` in equal parts of `steps` full steps,
  /// in place of any change under way. @param goal 0 < goal <= 1 [-]; @param steps >= 1
  /// @throws std::invalid_argument if out of range, or without track_integrity
  void change_integrity(int point, double goal, int steps);
  /// Length of a full step [time], for updates of parts of it: they change integrities by their share. 0: every update
  /// is a full step. @throws std::invalid_argument if < 0 or not finite
  void set_step_length(double length);
  double integrity(int point) const; ///< w of state(), 0 < w <= 1 [-]
  /// Kirchhoff stress of state() that the body carries, METHOD.md (1.27) [stress].
  Stress<Dim> stress(int point) const;

  void accept(); ///< state_old = state
  void revert(); ///< state = state_old
  /// Whether a point starts the next step on the yield surface, in both states: what an element event decides, see
  /// accept_events. @throws std::invalid_argument if point is out of range
  void set_plastic(int point, bool plastic);
  /// Replaces both states (resume, copies).
  /// @throws std::invalid_argument on wrong sizes, numbers that are not finite, or det F <= 0; nothing has
  /// changed then
  void set_state(const WorkpieceState<Dim>& state);

  /// An internal variable of the law in state(), at all points [its unit].
  /// @param component of a symmetric tensor, in the order of Stress
  /// @throws std::invalid_argument if the law has no such variable (lists those it has), or no such component
  Eigen::VectorXd internal(const std::string& name, int component = 0) const;
  /// A modulus of the law, see MaterialLaw::moduli. @throws std::invalid_argument for an unknown name (lists those it has)
  double modulus(const std::string& name) const;
  /// Von Mises stress of the Kirchhoff stress that a point of state() carries [stress].
  /// @throws std::invalid_argument if point is out of range
  double stress_eq(int point) const;
  /// q/sigma_y - 1 there, of the effective stress: positive outside the yield surface, where only forward Euler leads [-].
  double yield_distance(int point) const;

  /// A point of either state, with the effective stress; points into it.
  PointState<Dim> point_old(int point) const;
  PointState<Dim> point_now(int point) const;
  /// The step of a point from state_old(), as healing leaves it (METHOD.md 1.12), to state().
  PointStep<Dim> point_step(int point) const;

private:
  double step_ratio() const;
  void move_integrity(double dt);
  void heal_start();
  const WorkpieceState<Dim>& start() const { return m_healing && m_updated ? m_start : m_state_old; }
  UpdateResult deform(int first_element, int end_element);
  UpdateResult update_points(int first, int end, int iteration);
  PiolaTangent<Dim> moduli(int point, TangentKind kind, double elastic_blend) const;
  RangeResult move_points(int first, const RangeStep<Dim>& step);
  PiolaTangent<Dim> user_moduli(int point) const;
  UserPoints<Dim>& given(const char* where);
  int offset_of(const std::string& name, int component, const char* where) const;
  void require_point(const char* where, int point) const;

  Discretization<Dim> m_discretization;
  std::shared_ptr<const MaterialLaw<Dim>> m_law;
  int m_num_internal; // per point
  UpdateOptions m_options;
  TangentAssembly<Dim> m_assembly;
  AxisNodes<Dim> m_axis;
  WorkpieceState<Dim> m_state_old, m_state;
  std::vector<PointTrial> m_trial; // per point, this step
  std::optional<UserPoints<Dim>> m_user;
  WorkpieceState<Dim> m_start; // m_state_old with the points that heal in this step, while m_healing
  double m_step_length = 0;
  bool m_healing = false;
  bool m_updated = false; // state() comes from update, not from accept, revert, set_state
};

} // namespace burnish

#pragma once
// The deformable body: quadrature-point state at the start and at the end of a step, internal force, tangent.
// Knows no tool. A step can always be repeated: `accept` and `revert` are the only ways between the states.
#include "material/point_update.hpp"
#include "mesh/discretization.hpp"
#include "solver/node_block_matrix.hpp"
#include <vector>

namespace burnish {

/// Plain data, can be written and read. Point-major arrays.
template <int Dim> struct WorkpieceState {
  Eigen::VectorXd displacement;          ///< num_dofs [length]
  std::vector<double> F;                 ///< num_points x num_gradient: deformation gradient (Gradient) [-]
  std::vector<double> stress;            ///< num_points x num_stress: Kirchhoff stress [stress]
  std::vector<double> plastic_strain_eq; ///< num_points [-]
  std::vector<double> strain_increment;  ///< num_points x num_stress: dd of the step that ended here [-]
  std::vector<char> plastic;             ///< num_points: plastic flow happened in that step
  double dt = 0;                         ///< length of that step [time]; 0: there was none
};

enum class UpdateStatus { OK, INVERTED_ELEMENT, NOT_FINITE };
struct UpdateResult {
  UpdateStatus status = UpdateStatus::OK;
  int point = -1; ///< first point concerned
  double value =
      0; ///< the determinant(F) (or of F_mid = (F_old + F)/2) that is not > 0, or not finite, there
};

template <int Dim> class Workpiece {
public:
  /// Undeformed and free of stress.
  /// @throws std::invalid_argument if the arrays of the discretization do not fit together, or a parameter or
  ///         an option is outside its range
  Workpiece(Discretization<Dim> discretization, J2Parameters material, UpdateOptions options = {});
  const Discretization<Dim>& discretization() const { return m_discretization; }
  const J2Parameters& material() const { return m_material; }
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
  ///                     freeze_iteration and is frozen from there on (a point that yields later gets one
  ///                     then)
  /// @throws std::invalid_argument if the size, dt, iteration or an option is wrong, or where axisymmetric a
  ///         node on the axis has u_r other than 0 but for rounding (names it): the solver must hold it
  UpdateResult update(const Eigen::VectorXd& displacement, double dt, int iteration);
  /// Internal force of state(): sum over points V0 P grad_X N, P = tau F^-T, and where axisymmetric V0 P_zz
  /// N/R on the radial dof, the force of the whole ring; num_dofs [force].
  Eigen::VectorXd internal_force() const;
  /// Its tangent (symmetric part), into a matrix with this discretization's pattern: replaces the values.
  /// Right after accept, revert or set_state the increment is zero and CONSISTENT means RATE, its limit for a
  /// step that goes on like the last one. RATE: a point loads if it flowed in the last update.
  /// @param elastic_blend 0..1: share of the elastic moduli mixed into plastic points (algorithms.md 5.2)
  /// @throws std::invalid_argument if the pattern is another one or elastic_blend is out of range
  void tangent(NodeBlockMatrix<Dim>& matrix, TangentKind kind, double elastic_blend = 0) const;
  NodeBlockMatrix<Dim> pattern() const { return m_pattern; }
  /// Moduli A = dP/dF at a point, symmetrized, row-major on [du/dx, du/dy, dv/dx, dv/dy, hoop u/R], and first
  /// Piola stress P in the same order (num_gradient numbers): what a script's own forms need [stress].
  /// @throws std::invalid_argument if point or elastic_blend is out of range
  void point_moduli(int point, TangentKind kind, double elastic_blend, double* A) const;
  void point_piola(int point, double* P) const;

  void accept(); ///< state_old = state
  void revert(); ///< state = state_old
  /// Whether a point starts the next step on the yield surface, in both states: what an element event tells.
  /// Right after accept or revert. @throws std::invalid_argument if point is out of range
  void set_plastic(int point, bool plastic);
  /// Replaces both states (restart, tests).
  /// @throws std::invalid_argument on wrong sizes, numbers that are not finite, or det F <= 0
  void set_state(const WorkpieceState<Dim>& state);

  /// Von Mises stress of the Kirchhoff stress at a point of state() [stress].
  /// @throws std::invalid_argument if point is out of range
  double stress_eq(int point) const;
  /// q/sigma_y(ep) - 1 there: positive outside the yield surface, where only forward Euler leads [-].
  double yield_excess(int point) const;

private:
  Gradient<Dim> gradient_of_deformation(int element, int point, const Eigen::VectorXd& displacement) const;
  PointOld<Dim> point_old(int point) const;
  PointScheme scheme(double ratio, int substeps) const;
  double step_ratio() const;
  void check_axis(const Eigen::VectorXd& displacement) const;
  bool update_point(int point, const Gradient<Dim>& F, double ratio, bool may_grow, UpdateResult& result);
  PiolaTangent<Dim> moduli(int point, TangentKind kind, double elastic_blend) const;
  PiolaTangent<Dim> consistent_at(int point, const Gradient<Dim>& F, const Stress<Dim>& stress) const;
  template <int Hoop>
  void add_point(NodeBlockMatrix<Dim>& matrix, int element, int point, const PiolaTangent<Dim>& A) const;

  Discretization<Dim> m_discretization;
  J2Parameters m_material;
  UpdateOptions m_options;
  WorkpieceState<Dim> m_state_old, m_state;
  std::vector<int> m_substeps;      // per point, this step; 0: elastic so far
  std::vector<int> m_used_substeps; // per point, of the last update; 0: elastic
  bool m_updated = false;           // state() comes from update, not from accept, revert, set_state
  NodeBlockMatrix<Dim> m_pattern;   // values zero
  std::vector<int> m_slot;          // element x node x node: block in the pattern
  std::vector<int> m_axis;          // nodes on the axis, where axisymmetric
  double m_rounding = 0;            // of coordinates [length]
};

} // namespace burnish

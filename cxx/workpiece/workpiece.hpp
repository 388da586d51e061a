#pragma once
// The deformable body: quadrature-point state at the start and at the end of a step, internal force and tangent.
// Knows no tool. A step can always be repeated: `accept` and `revert` are the only ways between the two states.
#include "material/j2.hpp"
#include "mesh/discretization.hpp"
#include "solver/node_block_matrix.hpp"
#include <vector>

namespace burnish {

/// Plain data, can be written and read. Point-major arrays.
template <int Dim> struct WorkpieceState {
  Eigen::VectorXd displacement;          ///< num_dofs [length]
  std::vector<double> F;                 ///< num_points x Dim x Dim, row-major: deformation gradient [-]
  std::vector<double> stress;            ///< num_points x num_stress: Kirchhoff stress [stress]
  std::vector<double> plastic_strain_eq; ///< num_points [-]
  std::vector<double> strain_increment;  ///< num_points x num_stress: strain increment dd of the step that ended here [-]
  std::vector<char> plastic;             ///< num_points: plastic flow happened in that step
  double dt = 0;                         ///< length of that step [time]
};

struct UpdateOptions {
  StressUpdate update = StressUpdate::SUBSTEPPED;
  double path_limit = 1.5;        ///< L of algorithms.md section 2
  int min_substeps = 3, max_substeps = 20;
  double substep_strain = 0.3;    ///< substep when q(De) exceeds this fraction of sigma_y
  int freeze_iteration = 3;       ///< number of substeps may only grow before, is frozen from here on
};

enum class UpdateStatus { OK, INVERTED_ELEMENT, NOT_FINITE };
struct UpdateResult {
  UpdateStatus status = UpdateStatus::OK;
  int point = -1;    ///< first point concerned
  double value = 0;  ///< det F there
};

template <int Dim> class Workpiece {
public:
  Workpiece(Discretization<Dim> discretization, J2Parameters material, UpdateOptions options = {});
  const Discretization<Dim>& discretization() const { return m_discretization; }
  const J2Parameters& material() const { return m_material; }
  const WorkpieceState<Dim>& state_old() const { return m_state_old; }
  const WorkpieceState<Dim>& state() const { return m_state; }
  UpdateOptions& options() { return m_options; }

  /// Stress at the end of a step that leads from state_old to `displacement`, pure in state_old: writes state().
  /// @param displacement total displacement, num_dofs [length]; @param dt step length > 0 [time]
  /// @param iteration    0,1,2.. within the step; governs the freezing of the number of substeps
  UpdateResult update(const Eigen::VectorXd& displacement, double dt, int iteration);
  /// Internal force of state(): sum over points V0 P grad_X N, P = tau F^-T, num_dofs [force].
  Eigen::VectorXd internal_force() const;
  /// Its tangent (symmetric part), into a matrix with this discretization's pattern.
  /// @param elastic_blend 0..1: share of the elastic moduli mixed into plastic points (algorithms.md 5.2)
  void tangent(NodeBlockMatrix<Dim>& matrix, TangentKind kind, double elastic_blend = 0) const;
  NodeBlockMatrix<Dim> pattern() const;
  /// Moduli A_iJkL at a point, (Dim*Dim) x (Dim*Dim) row-major on [du/dx, du/dy, dv/dx, dv/dy], symmetrized, and
  /// first Piola stress P (Dim x Dim row-major): what a script's own forms need.
  void point_moduli(int point, TangentKind kind, double elastic_blend, double* A) const;
  void point_piola(int point, double* P) const;

  void accept();  ///< state_old = state
  void revert();  ///< state = state_old
  /// Replaces both states (restart, tests). @throws std::invalid_argument on wrong sizes or NaN
  void set_state(const WorkpieceState<Dim>& state);

  /// Von Mises stress of the Kirchhoff stress at a point of state() [stress].
  double stress_eq(int point) const;

private:
  Discretization<Dim> m_discretization;
  J2Parameters m_material;
  UpdateOptions m_options;
  WorkpieceState<Dim> m_state_old, m_state;
  std::vector<int> m_substeps; // per point, this step
};

} // namespace burnish

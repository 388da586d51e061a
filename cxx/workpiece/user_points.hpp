#pragma once
// Stress and moduli of a user-defined law: the core moves the points, the owner of the law gives the rest, component by
// component, for all points at once.
#include "workpiece/workpiece_state.hpp"
#include <array>

namespace burnish {

template <int Dim> class UserPoints {
public:
  using Values = Eigen::Ref<const Eigen::VectorXd>; ///< one per point

  explicit UserPoints(const Discretization<Dim>& mesh);
  void expire(); ///< the points have moved: nothing is given for them yet

  /// Component of the Kirchhoff stress [stress], in the order of Stress.
  /// @throws std::invalid_argument "where: ..." for a component that does not exist, a wrong size, or a value that is not
  ///         finite (names the point and its place)
  void stress(int component, const Values& values, WorkpieceState<Dim>& state, const char* where);
  /// Component of the first Piola stress [stress], in the order of Gradient; out of the plane it may be left out in plane
  /// strain. With the last one tau = P F' follows.
  /// @throws std::invalid_argument also where P F' is not symmetric to 1e-9 of its norm
  void piola(int component, const Values& values, WorkpieceState<Dim>& state, const char* where);
  /// Moduli dP_row/dF_column [stress], in the order of Gradient; the symmetric entry follows unless it is given, too.
  void moduli(int row, int column, const Values& values, const char* where);
  /// Derivative of the Kirchhoff stress by a step's increments [stress]: rows in the order of Stress, columns the strain
  /// increment in that order, then the rotation. Exact for what METHOD.md (1.15) calls MA and MB.
  void jacobian(int row, int column, const Values& values, const char* where);

  /// @throws std::invalid_argument "where: ..." if some component is missing (names it)
  void require_stress(const char* where) const;
  void require_moduli(const char* where) const;
  /// Size and finite numbers. @throws std::invalid_argument naming `name`, the point and its place
  void check(const Values& values, const std::string& name, const char* where) const;
  bool has_jacobian() const { return m_by_increment; }
  PiolaTangent<Dim> moduli_of(int point) const { return m_moduli[static_cast<std::size_t>(point)]; }
  StressByIncrement<Dim> jacobian_of(int point) const { return m_jacobian[static_cast<std::size_t>(point)]; }

private:
  static constexpr int NG = num_gradient<Dim>, NS = num_stress<Dim>, NY = num_increments<Dim>;
  bool in_mesh(int gradient_component) const;
  void follow_piola(WorkpieceState<Dim>& state, const char* where);

  bool m_axisymmetric;
  std::vector<double> m_place; // num_points x Dim
  std::array<bool, NS> m_stress_given{};
  std::array<bool, NG> m_piola_given{};
  std::array<std::array<bool, NG>, NG> m_moduli_given{};
  std::array<std::array<bool, NY>, NS> m_jacobian_given{};
  bool m_by_piola = false, m_by_increment = false;
  std::vector<Gradient<Dim>> m_piola;
  std::vector<PiolaTangent<Dim>> m_moduli;
  std::vector<StressByIncrement<Dim>> m_jacobian;
};

} // namespace burnish

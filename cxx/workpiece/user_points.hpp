#pragma once
// Stress and moduli of a user-defined law: the core moves the points, the owner of the law gives the rest, component by
// component, for all points at once.
#include "workpiece/workpiece_state.hpp"
#include <array>

namespace burnish {

template <int Dim> class GivenPoints;

/// What was given since the points moved.
template <int Dim> class UserPoints {
public:
  explicit UserPoints(const Discretization<Dim>& mesh);
  void expire(); ///< the points move: nothing is given for them yet
  /// Moves some, in place of MaterialLaw::update_range: their strain increments; none flows yet.
  static RangeResult move(const MaterialLaw<Dim>& law, const RangeStep<Dim>& step,
                          const RangeUpdate<Dim>& now);
  /// @throws std::invalid_argument "where: ..." if some component is missing (names it)
  void require_stress(const char* where) const;
  void require_moduli(const char* where) const;
  /// A = dP/dF as given, or from d tau/dy by the kinematics of the step.
  PiolaTangent<Dim> moduli(int point, const MaterialLaw<Dim>& law, const PointStep<Dim>& step,
                           const PointState<Dim>& now) const;

private:
  friend class GivenPoints<Dim>;
  static constexpr int NG = num_gradient<Dim>, NS = num_stress<Dim>, NY = num_increments<Dim>;
  bool in_mesh(int gradient_component) const;

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

/// Takes what is given for the state of a workpiece, see Workpiece::given. Everything throws std::invalid_argument
/// "where: ..." for a component that does not exist, a wrong size, or a value that is not finite (names the point and its
/// place).
template <int Dim> class GivenPoints {
public:
  using Values = Eigen::Ref<const Eigen::VectorXd>; ///< one per point

  /// All must outlive it. @param old start of the step that leads to `now`
  GivenPoints(UserPoints<Dim>& points, const MaterialLaw<Dim>& law, const WorkpieceState<Dim>& old,
              WorkpieceState<Dim>& now, const char* where)
      : m_points(points), m_law(law), m_old(old), m_now(now), m_where(where) {}
  /// Component of the Kirchhoff stress [stress], in the order of Stress.
  void stress(int component, const Values& values) const;
  /// Component of the first Piola stress [stress], in the order of Gradient; out of the plane it may be left out in plane
  /// strain. With the last one tau = P F' follows.
  /// @throws std::invalid_argument also where P F' is not symmetric to 1e-9 of its norm
  void piola(int component, const Values& values) const;
  /// Moduli dP_row/dF_column [stress], in the order of Gradient; the symmetric entry follows unless it is given, too.
  void moduli(int row, int column, const Values& values) const;
  /// Derivative of the Kirchhoff stress by a step's increments [stress]: rows in the order of Stress, columns the strain
  /// increment in that order, then the rotation. Exact for what METHOD.md (1.15) calls MA and MB.
  void jacobian(int row, int column, const Values& values) const;
  /// An internal variable of the law. A plastic_strain_eq that has grown in the step makes a point a plastic one.
  void internal(const std::string& name, int component, const Values& values) const;

private:
  static constexpr int NG = num_gradient<Dim>, NS = num_stress<Dim>, NY = num_increments<Dim>;
  void check(const Values& values, const std::string& name) const;
  void follow_piola() const;

  UserPoints<Dim>& m_points;
  const MaterialLaw<Dim>& m_law;
  const WorkpieceState<Dim>& m_old;
  WorkpieceState<Dim>& m_now;
  const char* m_where;
};

} // namespace burnish

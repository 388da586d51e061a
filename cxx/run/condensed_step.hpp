#pragma once
// A step by a sparse solver of the caller's choice: condense, solve, expand.
#include "iteration/condensed_iteration.hpp"
#include "run/body_loads.hpp"
#include "run/step_under_way.hpp"
#include "solver/unsymmetric_solver.hpp"
#include <functional>

namespace burnish {

template <int Dim> class CondensedStep {
public:
  /// All must outlive it. @param start contact state at the start of the step
  CondensedStep(Iteration<Dim>& iteration, BodyLoads<Dim>& loads, StepUnderWay<Dim>& step,
                const ContactState<Dim>& start);
  void begin(); ///< a step
  /// @param K tangent at u; @param R internal nodal force there [force]; @param half only the upper triangle is wanted
  const CondensedSystem& condense(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u,
                                  const Eigen::VectorXd& R, GeometricTerms terms, RightHandSide right,
                                  bool half);
  /// Takes the solution as one iteration: u, slips and coordinates move; in a step of IMPLICIT the contact states are tested
  /// with the forces that it predicts. In a step of RATES everything is linear in the solution, so contact nodes leave a curved
  /// tool by the square of the step. @returns the largest displacement increment [length]
  double expand(const Eigen::VectorXd& z, Eigen::VectorXd& u);
  /// Whether a sparse factor for every pass of the states costs less than the dense block of the nodes in contact, ALGORITHMS.md 8.8;
  /// only where it did so in the last iteration of the step. @param pattern of K, asked for once
  bool pays(const std::function<NodeBlockMatrix<Dim>()>& pattern);
  /// One iteration by UMFPACK: condense, solve, expand until the states agree. @returns false if a system is singular, or so few nodes
  /// are left in contact that it does not pay; nothing has moved then
  bool iterate(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& R, Eigen::VectorXd& u);
  /// States have changed and nothing has moved: the same K is condensed anew, see CondensedIteration::advance.
  bool again() const { return m_way.again(); }
  bool gave_up() const { return m_way.gave_up(); } ///< see CondensedIteration
  /// Shortens a RATES step after expand: displacements, slips, coordinates and program are linear in the
  /// fraction. @throws std::invalid_argument unless 0 < fraction <= 1 and the step is one of RATES
  void cut(Eigen::VectorXd& u, double fraction);

private:
  Iteration<Dim>& m_iteration;
  BodyLoads<Dim>& m_loads;
  StepUnderWay<Dim>& m_step;
  const ContactState<Dim>& m_start;
  CondensedIteration<Dim> m_way;
  Condensation<Dim> m_condensation;
  UnsymmetricSolver m_solver; // of this step: a run that goes on from a file comes to the same bits
  double m_fill = 0;          // numbers in a factor of K, 0: not counted yet
};

} // namespace burnish

#pragma once
// Why a step has not converged in all its iterations.
#include "iteration/failure.hpp"
#include "iteration/step_balance.hpp"

namespace burnish {

/// Where the iteration stands. Refers to what belongs to it.
template <int Dim> struct LastIterate {
  const ContactModel<Dim>& model;
  const BodyView<Dim>& body;
  const ContactState<Dim>& state;
  const PrescribedValues& prescribed;
  const StepBalance<Dim>& balance;
  const IterationOptions& options;
  int number;           ///< iterations made
  int unsolved;         ///< of them the last ones whose window has no solution
  double last_residual; ///< of the iterate before, < 0: none [force]
  Eigen::VectorXd dq;   ///< of the last iteration; empty: unknown
  Eigen::VectorXd way;  ///< of the coordinates since the prediction
  const Eigen::VectorXd &first_dq, &u,
      &R; ///< of the first iteration; displacement and forces before the last one
};

/// NO_BALANCE, TOO_LITTLE_FRICTION, WEDGED or CYCLE.
template <int Dim> Failure not_converged(const LastIterate<Dim>& iterate);

} // namespace burnish

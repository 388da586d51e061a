#pragma once
// A step that has failed, as those see it who say why.
#include "contact/contact_setup.hpp"
#include "iteration/failure.hpp"
#include "workpiece/workpiece.hpp"

namespace burnish {

/// From the accepted state at t. Refers to what belongs to the run.
template <int Dim> struct FailedStep {
  const ContactSetup<Dim>& setup;
  const ContactState<Dim>& state;           ///< accepted
  const Eigen::VectorXd& u;                 ///< accepted [length]
  const Eigen::VectorXd& generalized_force; ///< on the tools, accepted [force, force length]
  const PrescribedValues &before,
      &prescribed;      ///< at the end of the last step, empty: there was none; of this one
  const Failure& found; ///< by the iteration; NONE: the workpiece could not follow
  const Workpiece<Dim>* workpiece = nullptr; ///< null: unknown
  double t = 0, dt = 0;
  double last_dt = 0, largest_dt = 0; ///< of the step before, 0: there was none; of the run so far
  bool on_hold = false;               ///< a soft hold acts
};

} // namespace burnish

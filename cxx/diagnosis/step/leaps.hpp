#pragma once
// Equilibria that a step has no way to: a tool that has passed the body, a jump beyond a limit load. A shorter step finds the
// way, or shows that there is none (ALGORITHMS.md 5.10).
#include "contact/contact_setup.hpp"
#include "iteration/failure.hpp"

namespace burnish {

constexpr double JUMP_RATE =
    5; ///< a coordinate under force that moves so many times faster than before jumps ...
constexpr double JUMP_LENGTH = 0.2; ///< ... if its tool's points move by more than this many spacings

/// Both ends of a step.
template <int Dim> struct SteppedPath {
  const ContactState<Dim>*start, *end;
  const Eigen::VectorXd *u_start, *u_end;
};

/// Lengths and increments of a step and of the one before.
struct StepRates {
  double dt, last_dt;              ///< last_dt 0: there was none
  const Eigen::VectorXd& last_dq;  ///< of the coordinates, in the last step
  const Eigen::VectorXd& last_du;  ///< of the displacements, in the last step
  const Eigen::VectorXd& first_dq; ///< by the first iteration of this step; empty: unknown
};

/// How far the points of the tool of coordinate k move with it, at most [length over the unit of the coordinate].
template <int Dim> double lever(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses, int k);

/// A node or a place between two of them that is outside of a tool at both ends of the step and inside on the way. Only
/// where tool and body move against one another by more than the tool's size. @returns the failure, or NONE
template <int Dim> Failure tool_passage(const ContactSetup<Dim>& setup, const SteppedPath<Dim>& path);

/// A coordinate under force that moves much faster than in the step before, and than the coordinates under motion: by
/// JUMP_RATE and JUMP_LENGTH. @returns the failure, or NONE
template <int Dim>
Failure sudden_jump(const ContactSetup<Dim>& setup, const SteppedPath<Dim>& path,
                    const PrescribedValues& prescribed, const StepRates& rates);

/// The surface of a workpiece that its supports do not hold, and that a tool touches, moves much further than tools and
/// supports, and than it did at the rate of the last step: by JUMP_RATE and JUMP_LENGTH. On a soft hold alone less is enough, at any
/// rate. @returns the failure, or NONE
/// @param on_hold a soft hold acts
template <int Dim>
Failure body_jump(const ContactSetup<Dim>& setup, const SteppedPath<Dim>& path, const StepRates& rates,
                  bool on_hold);

} // namespace burnish

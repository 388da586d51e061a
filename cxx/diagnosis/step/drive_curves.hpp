#pragma once
// Force over way of every coordinate in the accepted steps: whether a force has come to its largest value, and whether a
// falling force is followed down a branch that no dead load holds (ALGORITHMS.md 5.10).
#include "contact/contact_archive.hpp"
#include "contact/contact_setup.hpp"
#include "iteration/failure.hpp"

namespace burnish {

/// The end of an accepted step, for one coordinate.
struct DrivePoint {
  double q = 0;       ///< [length or -]
  double force = 0;   ///< generalized force on the tool [force, force length]
  double contact = 0; ///< size of the contact force of its tool [force]
  double driven = 0;  ///< way of the coordinates under motion up to here [length]
  BURNISH_FIELDS(q, force, contact, driven)
};

/// A branch of falling force under way: coordinates go on while the forces that drive them fall.
struct FallingBranch {
  int coordinate = -1;    ///< that gives off most work; -1: no such branch
  double since = 0;       ///< time of its start
  double q = 0, from = 0; ///< coordinate and force at its start
  BURNISH_FIELDS(coordinate, since, q, from)
};

/// An accepted step of the drives.
struct DrivenStep {
  const Eigen::VectorXd &before, &after;    ///< coordinates
  const PrescribedValues &old, &prescribed; ///< at its start, empty: it is the first step; at its end
  const Eigen::VectorXd& force;   ///< of the drives at its end, one per coordinate [force, force length]
  const Eigen::VectorXd& contact; ///< size of the contact force, one per tool [force]
  double t = 0;                   ///< its end [time]
};

template <int Dim> class DriveCurves {
public:
  void add(const ContactSetup<Dim>& setup, const DrivenStep& step);

  /// A force that grows, of a coordinate whose force has hardly grown over the last part of its way: nothing balances more.
  /// @param before, prescribed values at the end of the last step, and of the one that fails
  /// @returns EXHAUSTED, or NONE
  Failure exhausted(const ContactSetup<Dim>& setup, const PrescribedValues& before,
                    const PrescribedValues& prescribed) const;

  /// Whether coordinates under force go on by more than JUMP_LENGTH (leaps.hpp) while their force falls, those under motion
  /// at rest: second-order work < 0, an unstable branch behind a maximum of the force. @returns what to say of it, or ""
  std::string unstable(const ContactSetup<Dim>& setup) const;
  /// Way of the tool's points on that branch, 0: there is none [length].
  double branch_way() const;
  BURNISH_FIELDS(m_curves, m_force, m_lever, m_branch, m_driven, m_t)

private:
  void follow_branch(const ContactSetup<Dim>& setup, const DrivenStep& step);
  std::vector<std::vector<DrivePoint>> m_curves; // the first point: where the force began
  Eigen::VectorXd m_force, m_lever; // of the last step: at its end; how far points move, see lever
  FallingBranch m_branch;
  double m_driven = 0, m_t = 0;
};

} // namespace burnish

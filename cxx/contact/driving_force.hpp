#pragma once
// Generalized forces of the drives: numbers, or formulas of the coordinates with their stiffness (METHOD.md 2.4, 3.1).
#include "contact/contact_model.hpp"

namespace burnish {

/// Forces on the tools and how they change with the independent coordinates.
struct DrivingForce {
  Eigen::VectorXd
      value; ///< Q_k, one per coordinate [work over coordinate]; where a motion is given, its value
  Eigen::MatrixXd slope; ///< dQ_k/dq^l, square; zero rows where Q_k is a number; empty: all are
  /// Rounding that the forces carry at q, per coordinate [work over coordinate]; empty with `slope`.
  Eigen::VectorXd rounding;
};

/// The forces at q and their exact derivatives, those by coordinates that follow others passed on to these.
/// @throws FormulaDomainError where a formula has no finite value
template <int Dim>
DrivingForce driving_force(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                           const Eigen::VectorXd& q);

/// Per coordinate: 1 if its own force resists it, -dQ_k/dq^k > 0, so that it needs no contact. Empty: none does.
std::vector<char> held_by_drive(const DrivingForce& drive, const PrescribedValues& prescribed);

/// @throws std::invalid_argument naming two coordinates under force with dQ_k/dq^l other than dQ_l/dq^k: the condensed
/// matrix is not symmetric then
template <int Dim>
void require_symmetric_drive(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                             const DrivingForce& drive);

} // namespace burnish

#pragma once
// A jump (ALGORITHMS.md 9.4): where no equilibrium is near, the body is led to the next one by pieces of a march with a little
// viscosity. The program goes on in the first piece only and stands still then; what ends the march is an equilibrium without viscosity.
#include "run/step_scheme.hpp"
#include <optional>

namespace burnish {

template <int Dim> class JumpScheme final : public StepScheme<Dim> {
public:
  using StepScheme<Dim>::StepScheme;
  void start(double t, double dt) override;
  SchemeTask solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R) override;
  bool refused() const { return m_refused; } ///< REJECTED: it dissipates more than jumps may

private:
  SchemeTask piece(double from);
  SchemeTask give_up(Eigen::VectorXd& u, Eigen::VectorXd& R);
  SchemeTask march(Eigen::VectorXd& u, Eigen::VectorXd& R);
  SchemeTask arrive(Eigen::VectorXd& u, Eigen::VectorXd& R);

  std::optional<ContactRunState<Dim>> m_contact_start; // at the start of the step
  std::optional<BodyState<Dim>> m_body_start;
  double m_stiffness = 0;  // of the viscosity where a march begins [stress/length^2]
  double m_next = 0;       // of the next piece; 0: without
  double m_dissipated = 0; // by the viscosity of this march [force length]
  double m_standing = 0;   // length of a piece in which the program stands still [time]
  int m_pieces = 0;
  bool m_refused = false;
};

} // namespace burnish

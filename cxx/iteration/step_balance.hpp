#pragma once
// What counts as balance: the tolerance of the load, and of what every tool carries (ALGORITHMS.md 5.1).
#include "contact/balance.hpp"
#include "iteration/options.hpp"

namespace burnish {

/// Loads that tolerances are relative to. Plain data.
struct LoadMemory {
  double scale = 0;      ///< load of the tolerance: largest contact resultant of the accepted steps [force]
  Eigen::VectorXd tools; ///< the same of every tool alone; empty: none yet [force]
  double rounding = 0;   ///< residual that rounding leaves, of the last tangent [force]
};

template <int Dim> class StepBalance {
public:
  /// @param model, body, options must outlive it
  StepBalance(const ContactModel<Dim>& model, const BodyView<Dim>& body, const IterationOptions& options)
      : m_model(model), m_body(body), m_options(options) {}

  LoadMemory& memory() { return m_memory; }
  const LoadMemory& memory() const { return m_memory; }
  /// What a soft hold carries: a load as supports have it [force].
  void set_held(double force) { m_held = force; }
  /// True: free nodes may be as far inside a tool as contact nodes may be off it (ALGORITHMS.md 8.8).
  void set_coarse_gaps(bool coarse) { m_coarse_gaps = coarse; }

  /// Balance of an iterate, which last() is then. @param R internal minus external nodal force, num_dofs [force]
  void look(const ContactState<Dim>& state, const PrescribedValues& prescribed, const Eigen::VectorXd& u,
            const Eigen::VectorXd& R);
  const Balance& last() const { return m_last; }
  /// Load of the last look: that of the memory, or of the iterate if it is larger [force].
  double scale() const { return std::max(m_memory.scale, m_last.load); }
  /// Largest residual that counts as balance there [force]: the tolerance of the load, or what rounding leaves, but of that
  /// no more than the default tolerance of the load, and a billionth of it in any case.
  double allowed() const { return allowed(scale()); }
  /// Tolerances of the last look. Those of the state tests are tighter.
  Tolerances tolerances() const;
  Tolerances state_tolerances() const;
  /// The iterate is the end of the step: its loads count from now on.
  void remember();
  static constexpr double STATE_FORCE =
      0.1; ///< tolerance of forces in the state tests over that of the residual

private:
  double allowed(double scale) const;
  Eigen::VectorXd allowed_of_tools(double scale, const Eigen::VectorXd& tools) const;
  Tolerances tolerances(double scale, const Eigen::VectorXd& tools) const;

  const ContactModel<Dim>& m_model;
  const BodyView<Dim>& m_body;
  const IterationOptions& m_options;
  LoadMemory m_memory;
  double m_held = 0;
  bool m_coarse_gaps = false;
  Balance m_last;
};

} // namespace burnish

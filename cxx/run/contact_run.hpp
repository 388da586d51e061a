#pragma once
// A contact problem under way, behind the verbs of a step: begin, check, factorize, correct, events, accept, revert; or
// condense and expand with a solver of the caller's choice. What it is made of is ContactSetup; which verb comes when is
// the Stepper's matter, or a script's own.
#include "contact/contact_setup.hpp"
#include "iteration/corrector.hpp"
#include "iteration/predictor.hpp"
#include "run/condensed_step.hpp"

namespace burnish {

/// What jumps have taken (ALGORITHMS.md 9.4).
struct JumpMemory {
  long number = 0;
  double dissipated = 0; ///< by their viscosity [force length]
  double work = 0;       ///< of the tools on the body so far [force length]
};

/// All that the contact needs to go on after an accepted step. A copy goes on to the same bits.
template <int Dim> struct ContactRunState {
  ContactState<Dim> contact;
  std::vector<Eigen::VectorXd> references; ///< of the tools' coordinates, see Coordinates::reference
  Eigen::VectorXd u, R; ///< displacement [length], nodal force out of balance with tools and supports [force]
  Eigen::VectorXd generalized_force; ///< on the tools, one per coordinate [force, force length]
  PrescribedValues prescribed;       ///< at the end of the last step
  StepHistory<Dim> history;
  Eigen::VectorXd support_displacement; ///< prescribed at the end of the last step; empty: none [length]
  Eigen::VectorXd support_origin;       ///< what that was when the mesh of now began; empty: 0 [length]
  Eigen::VectorXd external;             ///< nodal forces of the last step; empty: none [force]
  bool external_lost = false;           ///< they acted on another mesh, see ExternalForces::lost
  HoldState hold;
  JumpMemory jumps;
  LoadMemory load;
  FactorMemory<Dim> factor;
  // what has been found and counted
  double largest_dt = 0; ///< that was ever tried [time]
  EventLog<Dim> log;
  std::vector<std::string> left_out; ///< coordinates that nothing resists
  IterationCounts counts;
};

template <int Dim> class ContactRun {
public:
  /// Closes the setup. All tools are where the script placed them, nothing is in contact.
  /// @throws std::invalid_argument for a setup without a tool
  explicit ContactRun(std::shared_ptr<ContactSetup<Dim>> setup, IterationOptions options = {});
  const ContactSetup<Dim>& setup() const { return *m_setup; }

  /// All that is needed to go on, between steps; set_state puts it in place of this run's.
  ContactRunState<Dim> state() const;
  void set_state(const ContactRunState<Dim>& state);
  const ContactRunState<Dim>& accepted() const { return m_accepted; }

  /// Moves one coordinate until the tool just touches the body and puts the touching nodes in contact.
  /// @returns the coordinate's value. @throws std::invalid_argument if it cannot touch by this coordinate
  /// alone, or would touch it from inside; nothing has changed then
  double approach(int tool, const std::string& coordinate, const Eigen::VectorXd& u);
  BodyLoads<Dim>& loads() { return m_loads; }
  const BodyLoads<Dim>& loads() const { return m_loads; }

  // --- one step; R is the internal nodal force at u, num_dofs [force]: external forces and that of the hold are taken off here
  /// @param u in: accepted displacement; out: predicted one. The prescriptions hold the values at the end of the step.
  /// @throws std::invalid_argument for dt <= 0, a coordinate without motion or force, force control without contact, a
  /// tool that starts inside the body, wrong sizes, NaN
  void begin(Eigen::VectorXd& u, double t, double dt, Stepping stepping);
  /// The convergence test; of a step of pure rates only whether there is a way to its end.
  StepStatus check(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  /// @param K what is moved here is freed before the factor is made
  FactorStatus factorize(NodeBlockMatrix<Dim> K, const Eigen::VectorXd& u);
  StepStatus correct(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  /// Earliest contact events between the accepted state and (u, R); see earliest_events.
  /// @param tolerance events this close to the earliest one are taken with it [fraction of the step]
  /// @param until events later than this fraction (plus the tolerance) do not count
  std::vector<ContactEvent<Dim>> events(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                        double tolerance = 1e-3, double until = 1) const;
  /// Element events of the present step, logged with its acceptance.
  void log_elements(const std::vector<ElementEvent<Dim>>& events) {
    m_step.log.add(events, m_step.t, m_step.dt);
  }
  /// The end of the step becomes the accepted state. @param events those located at the end (event stepping)
  void accept(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
              const std::vector<ContactEvent<Dim>>& events);
  /// A step of no length: the states change by these events, nothing moves.
  void accept_events(const std::vector<ContactEvent<Dim>>& events);
  void revert();
  /// The accepted state was reached by a jump from the displacement `before`: logs it. @param dissipated [force length]
  void add_jump(const Eigen::VectorXd& before, double dissipated);
  /// The same step by a sparse solver of the caller's choice.
  CondensedStep<Dim>& condensed() { return m_condensed; }

  const StepUnderWay<Dim>& step() const { return m_step; }
  Iteration<Dim>& iteration() { return m_iteration; }
  const Iteration<Dim>& iteration() const { return m_iteration; }
  Corrector<Dim>& corrector() { return m_corrector; }

private:
  void take_areas(ContactState<Dim>& state, const Eigen::VectorXd& u) const;
  PrescribedValues start_values() const;
  void take_places();
  Failure leaps(const Eigen::VectorXd& u) const;
  Prediction<Dim> predicted(const Eigen::VectorXd& u) const;
  void take_events(const std::vector<ContactEvent<Dim>>& events, const Eigen::VectorXd& u,
                   ContactState<Dim>& state) const;
  void update_tools();
  void begin_program(const Eigen::VectorXd& u, double end);
  void begin_body(double t, Stepping stepping, const Eigen::VectorXd& u);
  StepStatus checked(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  StepEnds<Dim> ends(const Eigen::VectorXd& u, const Eigen::VectorXd& R) const;

  std::shared_ptr<ContactSetup<Dim>> m_setup;
  Iteration<Dim> m_iteration;
  Corrector<Dim> m_corrector;
  Predictor<Dim> m_predictor;
  BodyLoads<Dim> m_loads;
  ContactRunState<Dim> m_accepted;
  StepUnderWay<Dim> m_step;
  CondensedStep<Dim> m_condensed;
};

} // namespace burnish

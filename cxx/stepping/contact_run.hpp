#pragma once
// A contact problem under way, behind the verbs of a step: begin, check, factorize, correct, events, accept, revert; or
// condense and expand with a solver of the caller's choice. What it is made of is ContactSetup; which verb comes when is
// the Stepper's matter, or a script's own.
#include "stepping/contact_setup.hpp"
#include "stepping/contact_warnings.hpp"
#include "stepping/corrector.hpp"
#include "stepping/drive_curves.hpp"
#include "stepping/event_log.hpp"
#include "stepping/hold.hpp"
#include "stepping/predictor.hpp"
#include "stepping/supports.hpp"

namespace burnish {

/// All that the contact needs to go on after an accepted step. A copy goes on to the same bits.
template <int Dim> struct ContactRunState {
  ContactState<Dim> contact;
  Eigen::VectorXd u, R;              ///< displacement [length], internal minus external nodal force [force]
  Eigen::VectorXd generalized_force; ///< on the tools, one per coordinate [force, force length]
  PrescribedValues prescribed;       ///< at the end of the last step
  StepHistory<Dim> history;
  Eigen::VectorXd support_displacement; ///< prescribed at the end of the last step; empty: none [length]
  HoldState hold;
  CorrectorMemory<Dim> corrector;
  // what has been found and counted
  double largest_dt = 0; ///< that was ever tried [time]
  EventLog<Dim> log;
  ContactWarnings<Dim> warnings;
  DriveCurves<Dim> drives;
  std::vector<std::string> left_out; ///< coordinates that nothing resists
  CorrectorCounts counts;
};

template <int Dim> class ContactRun {
public:
  /// Closes the setup. All tools are where the script placed them, nothing is in contact.
  /// @throws std::invalid_argument for a setup without a tool
  explicit ContactRun(std::shared_ptr<ContactSetup<Dim>> setup);

  const ContactSetup<Dim>& setup() const { return *m_setup; }
  const ContactModel<Dim>& model() const { return m_setup->model(); }
  const BodyView<Dim>& body() const { return m_setup->body(); }
  StepOptions& options() { return m_corrector.options(); }

  /// All that is needed to go on, between steps; set_state puts it in place of this run's.
  ContactRunState<Dim> state() const;
  void set_state(const ContactRunState<Dim>& state);
  const ContactRunState<Dim>& accepted() const { return m_accepted; }
  /// What has been found of the accepted steps, for those who look for more.
  FindingList& findings() { return m_accepted.warnings.findings(); }

  /// Moves one coordinate until the tool just touches the body and puts the touching nodes in contact.
  /// @returns the coordinate's value. @throws std::invalid_argument if it cannot touch by this coordinate
  /// alone, or would touch it from inside; nothing has changed then
  double approach(int tool, const std::string& coordinate, const Eigen::VectorXd& u);

  /// Prescribed displacement of the supports; takes effect with the next begin.
  Supports<Dim>& supports() { return m_supports; }
  /// Soft hold; a new one begins with the next begin.
  Hold<Dim>& hold() { return m_hold; }
  const Hold<Dim>& hold() const { return m_hold; }

  // --- one step
  /// @param u in: accepted displacement; out: predicted one. The prescriptions hold the values at the end of the step.
  /// @throws std::invalid_argument for dt <= 0, a coordinate without motion or force, force control without contact, a
  /// tool that starts inside the body, wrong sizes, NaN
  void begin(Eigen::VectorXd& u, double t, double dt, Stepping stepping);
  /// Puts the force of the hold at u into the residual force R of the step under way, before check.
  void add_hold(const Eigen::VectorXd& u, Eigen::VectorXd& R) const { m_hold.add_force(u, t_end(), R); }
  StepStatus check(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  /// The test of a step of pure rates: FAILED if a tool passed through the body.
  StepStatus check_rates(const Eigen::VectorXd& u);
  FactorStatus factorize(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u);
  StepStatus correct(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  /// @throws std::invalid_argument "where: ..." unless a step has been begun, or has been checked
  void require_begun(const char* where) const;
  void require_checked(const char* where) const;
  /// Earliest contact events between the accepted state and (u, R); see earliest_events.
  /// @param tolerance events this close to the earliest one are taken with it [fraction of the step]
  /// @param until events later than this fraction (plus the tolerance) do not count
  std::vector<ContactEvent<Dim>> events(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                        double tolerance = 1e-3, double until = 1) const;
  /// Element events of the present step, logged with its acceptance.
  void log_elements(const std::vector<ElementEvent<Dim>>& events) { m_log.add(events, m_t, m_dt); }
  /// The end of the step becomes the accepted state. @param events those located at the end (event stepping)
  void accept(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
              const std::vector<ContactEvent<Dim>>& events);
  /// A step of no length: the states change by these events, nothing moves.
  void accept_events(const std::vector<ContactEvent<Dim>>& events);
  void revert();

  // --- the same step by a sparse solver of the caller's choice
  const CondensedSystem& condense(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u,
                                  const Eigen::VectorXd& R, GeometricTerms terms, RightHandSide right,
                                  bool half);
  /// Takes the solution as one iteration: u, slips and coordinates move; in a step of IMPLICIT the contact states are
  /// tested with the forces that it predicts, and contact nodes are put onto their tools. In a step of RATES everything
  /// is linear in the solution, so contact nodes leave a curved tool by the square of the step.
  /// @returns the largest displacement increment [length]
  double expand(const Eigen::VectorXd& z, Eigen::VectorXd& u);
  /// Shortens a RATES step after expand: displacements, slips, coordinates and program are linear in the
  /// fraction. @throws std::invalid_argument unless 0 < fraction <= 1 and the step is one of RATES
  void cut(Eigen::VectorXd& u, double fraction);

  // --- what is known
  Corrector<Dim>& corrector() { return m_corrector; }
  const Corrector<Dim>& corrector() const { return m_corrector; }
  /// Why the step failed: the corrector's reason, and what may be behind it.
  /// @param of_body what may be behind it in the workpiece, "": nothing known
  std::string reason(const std::string& of_body = "") const;
  /// Coordinates left out so far, in the step under way too, since nothing resists them.
  std::vector<std::string> left_out() const;
  /// Reports a warning of a subject, once. The accepted state keeps it.
  void warn(const std::string& subject, const std::string& text) { m_accepted.warnings.add(subject, text); }
  double t_end() const { return m_t + m_dt; } ///< of the step under way
  /// Contact width and speed of the contact along the body in the last step, for the step control; 0 if
  /// unknown.
  double contact_width() const;
  double contact_speed() const;

private:
  void follow_drives(const PrescribedValues& old, const Eigen::VectorXd& R);
  void take_areas(ContactState<Dim>& state, const Eigen::VectorXd& u) const;
  PrescribedValues start_values() const;
  void take_places();
  std::string leaps(const Eigen::VectorXd& u) const;
  Prediction<Dim> predicted(const Eigen::VectorXd& u) const;
  void take_events(const std::vector<ContactEvent<Dim>>& events, const Eigen::VectorXd& u,
                   ContactState<Dim>& state) const;
  void update_tools();
  void begin_body(double t, Stepping stepping, const Eigen::VectorXd& u);
  const NodeBlockMatrix<Dim>& with_hold(const NodeBlockMatrix<Dim>& K);
  StepEnds<Dim> ends(const Eigen::VectorXd& u, const Eigen::VectorXd& R) const;

  std::shared_ptr<ContactSetup<Dim>> m_setup;
  Corrector<Dim> m_corrector;
  Predictor<Dim> m_predictor;
  Condensation<Dim> m_condensation;
  Supports<Dim> m_supports;
  Hold<Dim> m_hold;
  NodeBlockMatrix<Dim> m_held; // tangent with the hold
  ContactRunState<Dim> m_accepted;
  // of the step under way
  Eigen::VectorXd m_u_start;
  PrescribedValues m_prescribed, m_prescribed_start;
  /// What the step under way has seen.
  enum class Stage { NONE, BEGUN, CHECKED } m_stage = Stage::NONE;
  Stepping m_stepping = Stepping::IMPLICIT;
  double m_t = 0, m_dt = 0, m_largest_dt = 0;
  std::vector<std::string> m_left_out;
  EventLog<Dim> m_log;
};

} // namespace burnish

#pragma once
// The loop over the steps of a run, turned inside out: it says what has to be done next, and its caller, a script or a
// test, does it. One loop for all; every decision about steps is here, in StepControl and in the schemes.
#include "diagnosis/diagnosis.hpp"
#include "run/jump_scheme.hpp"
#include "run/step_control.hpp"
#include "run/step_scheme.hpp"

namespace burnish {

/// What the caller of a run does next.
enum class Task {
  PROGRAM,    ///< set motion or force of every coordinate for the instant target()
  ACCEPT_LAW, ///< the caller's law, if it has a state of its own: the end of the last step is its start now
  REVERT_LAW, ///< the same: back to the start of the step
  FORCES, ///< update the stress at u for a step of length dt(), iteration(); its internal nodal forces into R; refuse() if
          ///< the material cannot follow
  TANGENT, ///< factorize a tangent at u (ContactRun::factorize), or make the iteration: condense a tangent, solve, expand
           ///< into u (CondensedStep); refuse() if there is none
  SOLVE,   ///< pure rates: tangent, condense, solve, expand into u; refuse() if that fails
  RECORD,  ///< a step has been accepted: u and control().time() hold it
  FINISHED, ///< the end of the program has been reached
  STOPPED,  ///< the run has ended before: reason() tells why; u holds the last accepted state
};

enum class Scheme { IMPLICIT, EVENT, ARTICLE };

struct StepperOptions {
  Scheme scheme = Scheme::IMPLICIT;
  SchemeOptions events;
  double nodes_per_step = 1; ///< a rolling step is at least this many node spacings long
  bool forms_only = false;   ///< nothing is known of the stress: the body is there for its mesh
  double width_steps =
      14; ///< as StepControlOptions::steps_per_width: the contact counts as that many spacings wide
};

struct StepperCounts {
  long steps = 0, rejected = 0;
  long rolling = 0;  ///< steps in which the contact moved along the body
  double travel = 0; ///< of the contact in them, node spacings
  /// Node spacings that the contact rolls in a step, mean [-]; 0: it does not roll.
  double nodes_per_step() const { return rolling > 0 ? travel / rolling : 0; }
  SchemeCounts scheme;
};

/// All that a run needs to go on after an accepted step. Plain data; a copy goes on to the same bits, and so do its bytes
/// (run_archive.hpp).
template <int Dim> struct RunState {
  BodyState<Dim> body;
  ContactRunState<Dim> contact;
  StepControlState control;
  StepperCounts counts;
  Diagnosis<Dim> diagnosis;
  std::vector<std::vector<Prescription::Entry>> drives; ///< per tool: what its coordinates were given last
  Scheme scheme = Scheme::IMPLICIT;
  std::string last_rejection; ///< why the last step was rejected, and its length
  double rejected_dt = 0;
};

/// What a caller sees of the loop, whatever the dimension.
class StepLoop {
public:
  virtual ~StepLoop() = default;
  /// Does what follows from the last task, up to the next one. u, R belong to the caller: the first call takes u as the
  /// displacement at the start.
  virtual Task next(Eigen::VectorXd& u, Eigen::VectorXd& R) = 0;
  /// Instead of the last task: it cannot be done. The step is rejected and tried shorter.
  virtual void refuse(const std::string& reason) = 0;
  /// Ends the run at the last accepted state: the next task is STOPPED. An accepted step is recorded before.
  virtual void stop(const std::string& reason) = 0;
  /// The way through the steps from the next one on.
  virtual void set_scheme(Scheme scheme) = 0;
  /// What is said of the scene so far; nothing without the checks.
  virtual std::vector<Statement> report() const = 0;
  virtual bool halted() const = 0;   ///< a self-check has ended the run
  virtual double target() const = 0; ///< PROGRAM
  virtual double dt() const = 0;     ///< FORCES: length of the piece
  virtual Stepping stepping() const = 0;
  virtual int iteration() const = 0; ///< FORCES: 0, 1, 2, ... in this equilibrium
  virtual const StepControl& control() const = 0;
  virtual const StepperCounts& counts() const = 0;
  /// Estimated relative error that the length of the steps has made in the plastic strain increments [-]; < 0: none, see
  /// StepErrorState::estimate.
  virtual double error() const = 0;
  virtual const std::string& reason() const = 0; ///< STOPPED
  virtual bool at_floor() const = 0;             ///< STOPPED: no step is short enough
  /// Why the last step was rejected, and its length; "" before the first.
  virtual const std::string& last_rejection() const = 0;
  virtual double rejected_dt() const = 0;
};

template <int Dim> class Stepper final : public StepLoop {
public:
  /// @param contact, body, diagnosis must outlive it; the diagnosis starts anew
  Stepper(ContactRun<Dim>& contact, RunBody<Dim>& body, Diagnosis<Dim>& diagnosis, StepControl control,
          StepperOptions options);

  Task next(Eigen::VectorXd& u, Eigen::VectorXd& R) override;
  void refuse(const std::string& reason) override;
  void stop(const std::string& reason) override;
  void set_scheme(Scheme scheme) override { m_options.scheme = scheme; }
  std::vector<Statement> report() const override;
  bool halted() const override { return m_halted; }
  double target() const override { return m_scheme->solve().from + m_scheme->solve().dt; }
  double dt() const override { return m_scheme->solve().dt; }
  Stepping stepping() const override { return m_scheme->solve().stepping; }
  int iteration() const override { return m_iteration; }
  const StepControl& control() const override { return m_control; }
  const StepperCounts& counts() const override { return m_counts; }
  double error() const override { return m_body.step_error().estimate(); }
  const std::string& reason() const override { return m_reason; }
  bool at_floor() const override { return m_at_floor; }
  const std::string& last_rejection() const override { return m_last_rejection; }
  double rejected_dt() const override { return m_rejected_dt; }

  RunState<Dim> state() const;
  /// Goes on from another run's state. @throws std::invalid_argument if it is that of another body, contact or set of tools
  void set_state(const RunState<Dim>& state, Eigen::VectorXd& u, Eigen::VectorXd& R);

private:
  enum class Phase { STEP, ACCEPTED, PROGRAM, LAW, FORCES, TANGENT, SOLVE, RECORD, ENDED };
  Task begin_step();
  void propose();
  void measure_step();
  void warn_of_error();
  Task ask(Task task, Phase phase);
  Task try_step();
  Task begin_try();
  bool may_jump() const;
  Task ask_forces();
  Task begin_solve(Eigen::VectorXd& u);
  Task check(Eigen::VectorXd& u, Eigen::VectorXd& R);
  Task correct(Eigen::VectorXd& u, Eigen::VectorXd& R);
  Task solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R);
  Task accepted();
  AcceptedStep<Dim> seen() const;
  const Workpiece<Dim>* known_workpiece() const {
    return m_options.forms_only ? nullptr : &m_body.workpiece();
  }
  void look(double dt);
  Task rejected(Eigen::VectorXd& u, Eigen::VectorXd& R);
  Task end(Eigen::VectorXd& u, Eigen::VectorXd& R);

  ContactRun<Dim>& m_contact;
  RunBody<Dim>& m_body;
  Diagnosis<Dim>& m_diagnosis;
  StepControl m_control;
  StepperOptions m_options;
  StepperCounts m_counts;
  ImplicitScheme<Dim> m_implicit;
  JumpScheme<Dim> m_jump;
  EventScheme<Dim> m_event;
  ArticleScheme<Dim> m_article;
  StepScheme<Dim>* m_scheme; // of the present try
  Phase m_phase = Phase::STEP;
  int m_tries = 0, m_marches = 0, m_iteration = 0;
  int m_made = 0; // iterations of this equilibrium at its last check
  bool m_refused = false, m_stopped = false, m_at_floor = false, m_halted = false;
  std::string m_refusal, m_reason, m_last_rejection;
  std::string m_refused_jump; // why a jump was given up since the run last went on, "" if none was
  double m_rejected_dt = 0;
};

} // namespace burnish

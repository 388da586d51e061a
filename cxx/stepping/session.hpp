#pragma once
// Everything a step loop needs, behind a few verbs: start, begin, check, factorize, correct, events, accept,
// revert. One object per contact set; the loop itself stays a script.
#include "contact/condensation.hpp"
#include "contact/events.hpp"
#include "contact/surface.hpp"
#include "kinematics/driven_tool.hpp"
#include "stepping/corrector.hpp"
#include "stepping/predictor.hpp"
#include "workpiece/element_events.hpp"

namespace burnish {

enum class Stepping {
  IMPLICIT, ///< contact states inside the iteration, last step carried along as predictor
  EVENT,    ///< contact states fixed: the loop cuts the step at events
  RATES,    ///< the same without prediction or correction: one linear solve from the accepted state (article)
};

template <int Dim> class Session {
public:
  /// @param surface edges of the contact surface; its nodes without given displacement are the candidates
  /// @param fixed per dof: displacement is given
  /// @throws std::invalid_argument for an empty contact set or wrong sizes
  Session(Mesh<Dim> mesh, std::vector<Facet<2>> surface, std::vector<char> fixed, StepOptions options = {});

  /// @throws std::invalid_argument after the first step began
  /// @param reach edges that the tool may touch; empty: the whole contact surface
  void add_tool(std::shared_ptr<DrivenTool<Dim>> tool, std::shared_ptr<const FrictionLaw> friction,
                const std::vector<Facet<2>>& reach = {});
  /// Moves one coordinate until the tool just touches the body and puts the touching nodes in contact.
  /// @returns the coordinate's value. @throws std::invalid_argument if it cannot touch by this coordinate
  /// alone, or would touch it from inside
  double approach(int tool, const std::string& coordinate, const Eigen::VectorXd& u);

  // --- one step
  /// @param u in: accepted displacement; out: predicted one. Drives hold the values at the end of the step.
  /// @throws std::invalid_argument for dt <= 0, an undriven coordinate, force control without contact, a tool
  /// that starts inside the body, wrong sizes, NaN
  void begin(Eigen::VectorXd& u, double t, double dt, Stepping stepping);
  StepStatus check(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  FactorStatus factorize(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u);
  StepStatus correct(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  /// Earliest contact events between the accepted state and (u, R); see earliest_events.
  /// @param tolerance events this close to the earliest one are taken with it [fraction of the step]
  /// @param until events later than this fraction (plus the tolerance) do not count
  std::vector<ContactEvent<Dim>> events(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                        double tolerance = 1e-3, double until = 1) const;
  /// Appends element events of the present step to the log: candidate and tool -1, node = quadrature point. In
  /// the order of time among themselves.
  void log(const std::vector<ElementEvent<Dim>>& events);
  /// Changes states at the accepted state without moving (events at fraction zero).
  void switch_states(const std::vector<ContactEvent<Dim>>& events);
  /// The end of the step becomes the accepted state. @param events those located at the end (event stepping)
  void accept(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
              const std::vector<ContactEvent<Dim>>& events);
  void revert();

  // --- the same step by a sparse solver of the caller's choice
  const CondensedSystem& condense(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u,
                                  const Eigen::VectorXd& R, GeometricTerms terms, RightHandSide right,
                                  bool half);
  /// Adds the solution to u and to the states. Everything is linear in the solution, so contact nodes leave
  /// their curved tool by the square of the step; TOTAL takes that back in the next solve, RATES never.
  /// @returns the largest displacement increment [length]
  double expand(const Eigen::VectorXd& z, Eigen::VectorXd& u);
  /// Shortens a RATES step after expand: displacements, slips, coordinates and program are linear in the
  /// fraction. @throws std::invalid_argument unless 0 < fraction <= 1 and the step is one of RATES
  void cut(Eigen::VectorXd& u, double fraction);

  // --- what is known
  Corrector<Dim>& corrector() { return *m_corrector; }
  const Corrector<Dim>& corrector() const { return *m_corrector; }
  /// Why the step failed: the corrector's reason, and what may be behind it, a jump of the program or
  /// the end of a tool's profile in the contact; "" before the first
  /// step.
  std::string reason() const;
  const ContactModel<Dim>& model() const { return m_corrector->model(); }
  const ContactState<Dim>& accepted() const { return m_accepted; }
  bool started() const { return m_corrector != nullptr; }
  const Mesh<Dim>& mesh() const { return *m_mesh; }
  const std::vector<std::shared_ptr<DrivenTool<Dim>>>& tools() const { return m_tools; }
  const std::vector<int>& candidates() const { return m_candidates; }
  const std::vector<Facet<2>>& surface() const { return m_surface; }
  const Eigen::VectorXd& accepted_displacement() const { return m_u; }
  const Eigen::VectorXd& accepted_force() const { return m_R; }
  const std::vector<ContactEvent<Dim>>& log() const { return m_log; }
  long condensations() const { return m_condensations; } ///< matrices made by condense
  const std::vector<std::string>& left_out() const {
    return m_left_out;
  } ///< coordinates that nothing resists
  /// What the scene asks for beyond what it can give, each once: (subject, text).
  const std::vector<std::pair<std::string, std::string>>& warnings() const { return m_warnings; }
  /// Contact width and speed of the contact along the body in the last step, for the step control; 0 if
  /// unknown.
  double contact_width() const;
  double contact_speed() const;
  /// Starts the correctors; called by the first begin() or approach().
  void start();

private:
  struct SmallestGap {
    double gap = 0, slope = 0, lever = 0;
    double fastest = 0, bending = 0; // largest |X_,k| and |X_,kk|/2 of all candidates' feet
    std::vector<std::size_t> nodes;  // candidates that have it
  };
  SmallestGap smallest_gap(int tool, int k, const Eigen::VectorXd& u);
  Program read_program();
  Prediction<Dim> predicted(const Eigen::VectorXd& u);
  void match_old_program();
  Prediction<Dim> resting(const Eigen::VectorXd& u) const;
  void keep_support(ContactState<Dim>& state, const std::vector<ContactEvent<Dim>>& events) const;
  std::vector<int> supports() const;
  void check_support(const Program& program) const;
  void check_independent(const Program& program) const;
  void drop_unresisted(Program& program);
  void check_not_placed() const;
  void check_not_inside(const Eigen::VectorXd& u) const;
  Vector<Dim> outward(int node, const Eigen::VectorXd& u) const;
  void check_from_outside(int tool, const std::vector<std::size_t>& touching, const Eigen::VectorXd& u) const;
  [[noreturn]] void fail_approach(int tool, const std::string& coordinate) const;
  std::string jump() const;
  std::string profile_end() const;
  bool within_body(int tool) const;
  void share_surface();
  void warn(const std::string& subject, const std::string& text);
  void warn_of_curvature();
  void note_conflicts(const ContactState<Dim>& state, const Eigen::VectorXd& u);
  void note_ends(const ContactState<Dim>& state, const Eigen::VectorXd& u);

  std::shared_ptr<const Mesh<Dim>> m_mesh;
  std::vector<Facet<2>> m_surface;
  std::vector<char> m_fixed;
  std::vector<int> m_candidates;
  StepOptions m_options;
  std::vector<std::shared_ptr<DrivenTool<Dim>>> m_tools;
  ContactModel<Dim> m_model;
  std::unique_ptr<Corrector<Dim>> m_corrector;
  std::unique_ptr<MeshLocator<Dim>> m_locator;
  std::unique_ptr<Condensation<Dim>> m_condensation;

  ContactState<Dim> m_accepted;
  Eigen::VectorXd m_u, m_R;
  Program m_program, m_program_old;
  StepHistory<Dim> m_history;
  Stepping m_stepping = Stepping::IMPLICIT;
  double m_t = 0, m_dt = 0, m_largest_dt = 0, m_load_scale = 0;
  int m_steps_since_factor = 0;
  long m_condensations = 0;
  std::vector<ContactEvent<Dim>> m_log;
  std::vector<std::string> m_left_out;
  std::vector<std::pair<std::string, std::string>> m_warnings;
};

} // namespace burnish

#pragma once
// A way through a step: which equilibria are solved one after another, and what is accepted. The Stepper does what a
// scheme asks for and reports how it went.
#include "run/contact_run.hpp"
#include "run/run_body.hpp"
#include <memory>

namespace burnish {

/// When events of quadrature points (yield, unloading) are located.
enum class ElementEvents {
  DEFAULT, ///< CUT with Scheme::ARTICLE, NONE otherwise
  NONE,
  LOG, ///< in every accepted step, logged with the contact events; the step stays whole
  CUT, ///< the step is cut at them, and at user-defined ones (an implicit step only logs)
};

struct SchemeOptions {
  ElementEvents elements = ElementEvents::DEFAULT;
  double event_tolerance =
      1e-3; ///< events this close to the earliest one are taken with it, fraction of the step
  double event_noise =
      1e-4;             ///< stress that the residual's tolerance leaves, over the yield stress (event steps)
  double jumps = 0.05;  ///< largest part of the drives' work that jumps may dissipate; 0: none are made
  int max_pieces = 100; ///< article: pieces of a step between events; the rest is then taken blindly
  int max_retries = 4;  ///< article: changes of state at one instant; a blind piece leads away from there
};

/// A piece shorter than this part of the step has no length: states change, nothing moves.
constexpr double AT_ONCE = 1e-6;
constexpr double SHORTEST_REST = 1e-9; ///< a rest of the step shorter than this part of it is none
/// Length, over the step, of a piece that leads away from an instant where states contradict.
constexpr double ESCAPE = 0.02;

/// What the caller has to do next, or how the step ended.
enum class SchemeTask {
  SOLVE,    ///< solve() anew, from the accepted state
  FORCES,   ///< stress and nodal forces at u for a piece of length solve().dt, then solved()
  ACCEPTED, ///< the step, or its part up to reached(), is accepted
  REJECTED, ///< nothing is accepted
};

/// One equilibrium: a piece of the step, from an accepted state.
struct Solve {
  double from = 0, dt = 0;
  Stepping stepping = Stepping::IMPLICIT;
};

struct SchemeCounts {
  long pieces = 0;    ///< accepted pieces of steps
  long pileups = 0;   ///< steps or pieces taken with the states inside the iteration because events piled up
  long at_once = 0;   ///< changes of state without progress
  long blind = 0;     ///< article: pieces that located no event
  double excess = -1; ///< article: largest q/sigma_y - 1 met
};

template <int Dim> class StepScheme {
public:
  StepScheme(ContactRun<Dim>& contact, RunBody<Dim>& body, const SchemeOptions& options, SchemeCounts& counts)
      : m_contact(contact), m_body(body), m_options(options), m_counts(counts) {}
  virtual ~StepScheme() = default;
  /// A step from t to t + dt begins. Sets solve().
  virtual void start(double t, double dt) = 0;
  /// Solve() has been carried out: u, R hold its end. @param converged false: it failed
  virtual SchemeTask solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R) = 0;
  const Solve& solve() const { return m_solve; }
  double reached() const { return m_reached; } ///< end of the part that is accepted

protected:
  /// Back to the accepted state.
  void revert(Eigen::VectorXd& u, Eigen::VectorXd& R);
  /// Logs the user-defined events of the piece and accepts it. @param events contact events at its end
  void accept(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
              const std::vector<ContactEvent<Dim>>& events);
  void log_all_elements();
  /// Earliest event of the piece, contact's, elements' and user-defined; 2 if there is none. Contact events found are in
  /// m_events, element events stay pending with the body; those later than the tolerance after the earliest are dropped.
  /// @param least user-defined events earlier than this fraction need no cut, since they change nothing
  double earliest(const Eigen::VectorXd& u, const Eigen::VectorXd& R, bool elements, double noise,
                  double least);

  ContactRun<Dim>& m_contact;
  RunBody<Dim>& m_body;
  const SchemeOptions& m_options;
  SchemeCounts& m_counts;
  Solve m_solve;
  double m_reached = 0;
  std::vector<ContactEvent<Dim>> m_events;
};

/// Implicit step (ALGORITHMS.md 9.1): contact states inside the iteration, one piece.
template <int Dim> class ImplicitScheme final : public StepScheme<Dim> {
public:
  using StepScheme<Dim>::StepScheme;
  void start(double t, double dt) override;
  SchemeTask solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R) override;
};

/// Event step (ALGORITHMS.md 9.2): from event to event through the step; every piece in equilibrium with fixed contact
/// states, which change only at its end. Where states contradict one another at one instant, a short piece with the
/// states inside the iteration finds the ones that agree.
template <int Dim> class EventScheme final : public StepScheme<Dim> {
public:
  using StepScheme<Dim>::StepScheme;
  void start(double t, double dt) override;
  SchemeTask solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R) override;

private:
  SchemeTask next_piece();
  void cut(double fraction, Eigen::VectorXd& u, Eigen::VectorXd& R);
  SchemeTask take_piece(Eigen::VectorXd& u, Eigen::VectorXd& R);

  double m_t = 0, m_dt = 0;
  int m_changes = 0, m_point_changes = 0; // at this instant
  int m_cuts = 0;
  bool m_adapt = false; // this piece has the states inside the iteration
};

/// The article's own scheme: pure rates, cut at the earliest event (ALGORITHMS.md 9.3, edp/run/rcArticle.idp).
template <int Dim> class ArticleScheme final : public StepScheme<Dim> {
public:
  using StepScheme<Dim>::StepScheme;
  void start(double t, double dt) override;
  SchemeTask solved(bool converged, Eigen::VectorXd& u, Eigen::VectorXd& R) override;

private:
  SchemeTask next_piece();
  SchemeTask change_at_once(Eigen::VectorXd& u, Eigen::VectorXd& R);
  SchemeTask take_piece(Eigen::VectorXd& u, Eigen::VectorXd& R);

  double m_t = 0, m_dt = 0;
  int m_pieces = 0, m_retries = 0;
  bool m_blind = false, m_cut = false;
};

} // namespace burnish

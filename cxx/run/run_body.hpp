#pragma once
// The deformable body as the steps of a run see it: two states, and events of its points. Stress, force and tangent are
// asked of whoever owns the law: its workpiece, or the forms of a script.
#include "workpiece/element_events.hpp"
#include "workpiece/point_damage.hpp"
#include "workpiece/step_error.hpp"

namespace burnish {

/// What a body needs to go on after an accepted step. Plain data.
template <int Dim> struct BodyState {
  WorkpieceState<Dim> workpiece;
  PointEventsState user; ///< user-defined events
  StepErrorState step_error;
};

/// What became of the last step.
enum class StateChange { NONE, ACCEPTED, REVERTED };

/// A workpiece with its user-defined events.
template <int Dim> class RunBody {
public:
  explicit RunBody(std::unique_ptr<Workpiece<Dim>> workpiece) : m_workpiece(std::move(workpiece)) {}
  Workpiece<Dim>& workpiece() { return *m_workpiece; }
  const Workpiece<Dim>& workpiece() const { return *m_workpiece; }
  PointEvents<Dim>& user() { return m_user; }
  const PointEvents<Dim>& user() const { return m_user; }
  PointDamage<Dim>& damage() { return m_damage; }
  const PointDamage<Dim>& damage() const { return m_damage; }
  bool has_damage() const { return !m_damage.empty(); } ///< user-defined events change points

  /// The accepted one.
  BodyState<Dim> state() const { return {m_workpiece->state_old(), m_user.state(), m_step_error}; }
  /// Replaces both states, between steps. @throws std::invalid_argument if it does not fit; nothing has changed then
  void set_state(const BodyState<Dim>& state);
  /// Another workpiece of the same law on a new mesh, between steps. @param origin per point of it: the old one nearest to it
  void replace(std::unique_ptr<Workpiece<Dim>> workpiece, const std::vector<int>& origin);
  void accept(); ///< the end of the step becomes the accepted state
  void revert(); ///< back to the accepted state
  /// What a law of the caller's with a state of its own has to follow before the next forces; each change once, however often
  /// it happened, an acceptance first. NONE for a law of the core. After start() and
  /// set_state() it has to go back to the accepted state.
  StateChange take_change();
  void start(); ///< a run begins
  /// What the accepted steps have shown of their error.
  StepErrorState step_error() const { return m_step_error; }

  // Element events of the step that the last update made. Those found stay pending until they are accepted, dropped or
  // found anew.
  /// The earliest ones and those within the tolerance of them [fractions of the step]; see element_events for the noise.
  /// @returns fraction of the earliest, 2 if there is none
  double find_earliest(double tolerance, double noise);
  void find_all();
  void drop_events() { m_pending.clear(); }
  const std::vector<ElementEvent<Dim>>& pending() const { return m_pending; }
  /// A step of no length: points that yielded are on the surface now, points that unloaded inside it.
  /// @returns their number
  long accept_events();

  /// Fraction of the earliest user-defined event beyond `least`, 2 if there is none.
  double find_earliest_user(double overshoot, double least);
  std::vector<ElementEvent<Dim>> user_events() const; ///< all of the step

private:
  std::unique_ptr<Workpiece<Dim>> m_workpiece;
  PointEvents<Dim> m_user;
  PointDamage<Dim> m_damage;
  std::vector<ElementEvent<Dim>> m_pending;
  StepErrorState m_step_error;
  bool m_accepted = false, m_reverted = true; // what the caller's law has not followed yet
};

} // namespace burnish

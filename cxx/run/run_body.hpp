#pragma once
// The deformable body as the steps of a run see it: two states, and events of its points. Stress, force and tangent are
// asked of whoever owns the law: a Workpiece, or the forms of a script.
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

template <int Dim> class RunBody {
public:
  virtual ~RunBody() = default;
  virtual BodyState<Dim> state() const = 0; ///< the accepted one
  /// Replaces both states, between steps. @throws std::invalid_argument if it does not fit; nothing has changed then
  virtual void set_state(const BodyState<Dim>& state) = 0;
  virtual void accept() = 0; ///< the end of the step becomes the accepted state
  virtual void revert() = 0; ///< back to the accepted state
  /// What a law of the caller's with a state of its own has to follow before the next forces; each change once, however often
  /// it happened, an acceptance first. NONE for a law of the core. After start() the accepted state is such a change.
  virtual StateChange take_change() = 0;
  virtual void start() = 0; ///< a run begins
  /// Length of the full step that begins [time], 0: every update is one. Damage counts full steps (METHOD.md 1.12).
  virtual void set_step_length(double length) = 0;
  virtual bool has_damage() const = 0; ///< user-defined events change points

  // Element events of the step that the last update made. Those found stay pending until they are accepted, dropped or
  // found anew.
  /// The earliest ones and those within the tolerance of them [fractions of the step]; see element_events for the noise.
  /// @returns fraction of the earliest, 2 if there is none
  virtual double find_earliest(double tolerance, double noise) = 0;
  virtual void find_all() = 0;
  virtual void drop_events() = 0;
  virtual const std::vector<ElementEvent<Dim>>& pending() const = 0;
  /// A step of no length: points that yielded are on the surface now, points that unloaded inside it.
  /// @returns their number
  virtual long accept_events() = 0;
  /// Before accept: points that flowed in the last step and rest within the noise of the surface count as flowing.
  virtual void keep_plastic(double noise) = 0;

  /// Fraction of the earliest user-defined event beyond `least`, 2 if there is none.
  virtual double find_earliest_user(double overshoot, double least) = 0;
  virtual std::vector<ElementEvent<Dim>> user_events() const = 0; ///< all of the step

  /// The workpiece itself, for the self-checks of a run; null if there is none.
  virtual const Workpiece<Dim>* checked() const { return nullptr; }
  /// What the accepted steps have shown of their error.
  virtual StepErrorState step_error() const { return {}; }

  /// Largest q/sigma_y - 1 of the points: how far the stress has left the yield surface.
  virtual double largest_yield_distance() const = 0;
};

/// A workpiece of the core with its user-defined events.
template <int Dim> class WorkpieceBody final : public RunBody<Dim> {
public:
  explicit WorkpieceBody(std::unique_ptr<Workpiece<Dim>> workpiece) : m_workpiece(std::move(workpiece)) {}
  Workpiece<Dim>& workpiece() { return *m_workpiece; }
  const Workpiece<Dim>& workpiece() const { return *m_workpiece; }
  PointEvents<Dim>& user() { return m_user; }
  PointDamage<Dim>& damage() { return m_damage; }

  BodyState<Dim> state() const override { return {m_workpiece->state_old(), m_user.state(), m_step_error}; }
  void set_state(const BodyState<Dim>& state) override;
  void accept() override;
  void revert() override;
  StateChange take_change() override;
  void start() override;
  void set_step_length(double length) override { m_workpiece->set_step_length(length); }
  bool has_damage() const override { return !m_damage.empty(); }
  double find_earliest(double tolerance, double noise) override;
  void find_all() override;
  void drop_events() override { m_pending.clear(); }
  const std::vector<ElementEvent<Dim>>& pending() const override { return m_pending; }
  long accept_events() override;
  void keep_plastic(double noise) override;
  double find_earliest_user(double overshoot, double least) override;
  std::vector<ElementEvent<Dim>> user_events() const override;
  double largest_yield_distance() const override;
  const Workpiece<Dim>* checked() const override { return m_workpiece.get(); }
  StepErrorState step_error() const override { return m_step_error; }

private:
  std::unique_ptr<Workpiece<Dim>> m_workpiece;
  PointEvents<Dim> m_user;
  PointDamage<Dim> m_damage;
  std::vector<ElementEvent<Dim>> m_pending;
  StepErrorState m_step_error;
  bool m_accepted = true, m_reverted = false; // what the caller's law has not followed yet
};

} // namespace burnish

#pragma once
// Events of quadrature points that a script defines by a formula on the state of a point (damage, healing, a
// yield condition, a place that is reached; ALGORITHMS.md 13). They find and count; what an event does to
// its point is in point_damage.hpp. Knows no tool.
#include "formula/formula.hpp"
#include "workpiece/element_events.hpp"
#include "workpiece/point_variables.hpp"
#include <map>
#include <string>

namespace burnish {

/// One event at the accepted state.
struct PointEventState {
  std::string name;
  std::vector<char> above; ///< per point: the formula is not below zero
  std::vector<int> count;  ///< per point: how often the event has happened
};
/// Of all events, in the order of their definition: what is needed to go on from an accepted step. Plain data.
using PointEventsState = std::vector<PointEventState>;

/// Named events of one workpiece, by formulas in the names of PointVariables. An event happens at a point
/// where its formula passes through zero upwards, from < 0 to >= 0. A point that is not below zero (at the
/// beginning, or since its event happened) has no event until the formula has fallen below zero.
///
/// Inside a step stress, internal variables and position are linear between the accepted state and the end of
/// the step; the formula is evaluated there at eighths of the step, and its root is found between two of
/// them. Changes that come and go within an eighth are not seen.
template <int Dim> class PointEvents {
public:
  bool empty() const { return m_formulas.empty(); }
  /// Registers an event, between steps; points whose formula is >= 0 in body.state_old() are above already.
  /// @param parameters numbers by name
  /// @returns the number of such points
  /// @throws std::invalid_argument if the name is empty, taken or holds a comma, quote or line break (it goes
  /// into tables); for a wrong formula, or one that is not finite somewhere now (see Formula)
  int add(const Workpiece<Dim>& body, const std::string& name, const std::string& formula,
          const std::map<std::string, double>& parameters = {});

  /// All events of the step that the last update made, by fraction; several per point and name if it rises
  /// again. @throws std::invalid_argument quoting formula and values where the formula is not finite
  std::vector<ElementEvent<Dim>> find(const Workpiece<Dim>& body) const;
  /// Fraction of the earliest one that lies beyond `least`, 2 if there is none: where to cut the step.
  double earliest(const Workpiece<Dim>& body, double least) const;
  /// Until accept or revert: points that would have their event before 1 + overshoot have it at the end of the step.
  /// @throws std::invalid_argument if overshoot < 0
  void set_overshoot(double overshoot);

  /// Counts the events of the step; right before body.accept(). @throws std::invalid_argument as find; nothing has
  /// changed then
  void accept(const Workpiece<Dim>& body);
  void revert() { m_overshoot = 0; }

  /// The accepted state.
  const PointEventsState& state() const { return m_state; }
  /// Replaces it (resume, copies). @throws std::invalid_argument unless it has these events, in this order,
  /// each with the same number of points as now; nothing has changed then
  void set_state(const PointEventsState& state);
  /// Other points in place of these, each with the state of one of them. @param origin per new point: the old one
  void take_points(const std::vector<int>& origin);

  /// How often the event has happened, per point and in all.
  /// @throws std::invalid_argument for an unknown name
  const std::vector<int>& counts(const std::string& name) const;
  long number(const std::string& name) const;
  /// Formula of every event with its numbers, by name.
  const std::map<std::string, std::string>& words() const { return m_words; }

private:
  std::vector<Formula> m_formulas; // as m_state
  std::map<std::string, std::string> m_words;
  PointEventsState m_state;
  double m_overshoot = 0; // of the step under way
};

} // namespace burnish

#pragma once
// Events of quadrature points that a script defines by a formula of its own on the state of a point (damage,
// healing, a yield condition, a place that is reached; article section 2, method.md section 4). They only
// tell: nothing in the workpiece changes by them. Knows no tool.
#include "base/formula.hpp"
#include "workpiece/element_events.hpp"
#include <map>
#include <string>

namespace burnish {

/// Names that a formula may use, at one point: ep accumulated plastic strain [-]; of the Kirchhoff stress
/// [stress]: seq von Mises, sm mean, sxx syy szz sxy components, s1 and s3 largest and smallest principal
/// stress; x, y present position [length]. seq is at least 1e-300, so that sm/seq is 0 without stress.
const std::vector<std::string>& point_event_variables();

/// Named events of one workpiece. An event happens at a point where its formula passes through zero upwards,
/// from < 0 to >= 0. A point that is not below zero (at the beginning, or since its event happened) has no
/// event until the formula has fallen below zero.
///
/// Inside a step stress, ep and position are linear between the accepted state and the end of the step; the
/// formula is evaluated there at eighths of the step, and its root is found between two of them. Changes that
/// come and go within an eighth are not seen.
template <int Dim> class PointEvents {
public:
  bool empty() const { return m_events.empty(); }
  /// Registers an event, between steps; points whose formula is >= 0 in body.state_old() are above already.
  /// @param parameters numbers by name
  /// @throws std::invalid_argument if the name is empty, taken or holds a comma, quote or line break (it goes
  /// into tables); for a wrong formula, or one that is not finite somewhere now (see Formula)
  void add(const Workpiece<Dim>& body, const std::string& name, const std::string& formula,
           const std::map<std::string, double>& parameters = {});

  /// All events of the step that the last update made, by fraction; several per point and name if it rises
  /// again. @throws std::invalid_argument quoting formula and values where the formula is not finite
  std::vector<ElementEvent<Dim>> find(const Workpiece<Dim>& body) const;
  /// Fraction of the earliest one that lies beyond `least`, 2 if there is none: where to cut the step.
  /// Remembers `overshoot` until accept or revert: from then on points that would have their event before
  /// 1 + overshoot have it at the end of the step. @throws std::invalid_argument if overshoot < 0
  double earliest(const Workpiece<Dim>& body, double overshoot, double least);

  /// Counts the events of the step; right before body.accept().
  void accept(const Workpiece<Dim>& body);
  void revert() { m_overshoot = 0; }

  /// How often the event has happened, per point and in all.
  /// @throws std::invalid_argument for an unknown name
  const std::vector<int>& counts(const std::string& name) const;
  long number(const std::string& name) const;

private:
  struct Event {
    std::string name;
    Formula formula;
    std::vector<char> above; ///< per point: not below zero at the accepted state
    std::vector<int> count;  ///< per point
  };
  const Event& event(const std::string& name) const;

  std::vector<Event> m_events;
  double m_overshoot = 0;
};

} // namespace burnish

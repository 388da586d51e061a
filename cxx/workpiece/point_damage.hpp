#pragma once
// What user-defined events do to their points: damage and healing (METHOD.md 1.12). Knows no tool.
#include "workpiece/point_events.hpp"

namespace burnish {

/// Rules of one workpiece: an event by its name changes the integrity of its point over a number of full steps.
template <int Dim> class PointDamage {
public:
  bool empty() const { return m_rules.empty(); }
  bool heals() const; ///< some event does
  /// What becomes of a point by this event: " -> integrity in n steps"; "": nothing.
  std::string words(const std::string& event) const;
  /// From the event on the integrity of a point falls to `integrity` in equal parts of `steps` full steps. Points at or
  /// below it stay as they are. The first rule makes the body track integrities.
  /// @param integrity 0 < integrity < 1 [-]; 0 is refused: a node whose elements all have it would have no stiffness
  /// @param steps >= 1
  /// @throws std::invalid_argument for an unknown event (lists those there are), one that has a rule already, numbers out
  ///         of range
  void damage(Workpiece<Dim>& body, const PointEvents<Dim>& events, const std::string& event,
              double integrity, int steps);
  /// From the event on the integrity grows to 1 in equal parts of `steps` full steps, in whole points nothing happens.
  /// @throws std::invalid_argument as damage, and where no damage is defined
  void heal(const PointEvents<Dim>& events, const std::string& event, int steps);

  /// Begins the changes that events cause, the later one of a point counts; right after body.accept().
  /// @param events of the accepted step, by fraction
  void apply(const std::vector<ElementEvent<Dim>>& events, Workpiece<Dim>& body) const;

private:
  struct Rule {
    double goal = 1; // < 1 damage, 1 healing
    int steps = 1;
  };
  void add(const PointEvents<Dim>& events, const std::string& event, const Rule& rule);

  std::map<std::string, Rule> m_rules; // by event
};

} // namespace burnish

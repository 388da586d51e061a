#include "workpiece/point_damage.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include <algorithm>
#include <iomanip>

namespace burnish {
namespace {

constexpr const char* POINT_DAMAGE = "PointDamage";

} // namespace

template <int Dim>
void PointDamage<Dim>::add(const PointEvents<Dim>& events, const std::string& event, const Rule& rule) {
  events.counts(event); // throws if there is none
  require(rule.steps >= 1, POINT_DAMAGE, "steps", rule.steps, ">= 1");
  if (m_rules.count(event) > 0)
    fail(POINT_DAMAGE, "event \"" + event + "\" damages or heals already, expected one rule an event");
  m_rules[event] = rule;
}

template <int Dim>
void PointDamage<Dim>::damage(Workpiece<Dim>& body, const PointEvents<Dim>& events, const std::string& event,
                              double integrity, int steps) {
  require(integrity > 0 && integrity < 1, POINT_DAMAGE, "integrity", integrity,
          "0 < integrity < 1; at 0 nodes would have no stiffness, and the tangent would be singular");
  add(events, event, {integrity, steps});
  body.track_integrity();
}

template <int Dim>
void PointDamage<Dim>::heal(const PointEvents<Dim>& events, const std::string& event, int steps) {
  if (empty())
    fail(POINT_DAMAGE, "event \"" + event + "\" has nothing to heal, expected damage to be defined before");
  add(events, event, {1, steps});
}

template <int Dim> bool PointDamage<Dim>::heals() const {
  return std::any_of(m_rules.begin(), m_rules.end(), [](const auto& rule) { return rule.second.goal == 1; });
}

template <int Dim> std::string PointDamage<Dim>::words(const std::string& event) const {
  const auto rule = m_rules.find(event);
  if (rule == m_rules.end()) return "";
  return sentence(std::setprecision(17), " -> ", rule->second.goal, " in ", rule->second.steps, " steps");
}

template <int Dim>
void PointDamage<Dim>::apply(const std::vector<ElementEvent<Dim>>& events, Workpiece<Dim>& body) const {
  for (const ElementEvent<Dim>& event : events) {
    const auto rule = m_rules.find(event.name);
    if (event.change != PointChange::USER || rule == m_rules.end()) continue;
    const auto [goal, steps] = rule->second;
    const double w = integrity_of(body.state(), event.point);
    if (goal == 1 ? w < 1 : goal < w) body.change_integrity(event.point, goal, steps);
  }
}

template class PointDamage<2>;
template class PointDamage<3>;

} // namespace burnish

#pragma once
// What counts as nothing in the tests of an iterate.
#include "contact/tangential_law.hpp"
#include <algorithm>

namespace burnish {

/// Absolute, of all tests: balance, states, events.
struct Tolerances {
  double force = 0;  ///< residual; tension and excess over the cone [force]
  double gap = 0;    ///< penetration [length]
  double slip = 0;   ///< slip against the friction [length]
  double offset = 0; ///< of a contact node from its tool [length]
  Eigen::VectorXd tool_force =
      {}; ///< per tool: the same as force for what belongs to it, no larger; empty: force
  double compliance =
      0; ///< largest of a contact node: what the tolerance of forces leaves of slips [length/force]

  double force_of(int tool) const { return tool_force.size() > 0 ? tool_force[tool] : force; }
  double slip_of(int tool) const { return std::max(slip, compliance * force_of(tool)); }
  ContactTolerance of(int tool) const { return {force_of(tool), slip_of(tool)}; }
  /// Of a residual that belongs to a tool, beside others: >= 1.
  double weight(int tool) const {
    const double own = force_of(tool);
    return own > 0 && own < force ? force / own : 1;
  }
};

} // namespace burnish

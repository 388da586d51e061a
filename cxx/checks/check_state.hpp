#pragma once
// What the self-checks carry from step to step. Plain data; a copy goes on to the same bits.
#include "base/types.hpp"
#include <map>
#include <string>
#include <vector>

namespace burnish {

/// Energies of the run so far [force length].
struct EnergyState {
  double tools = 0, supports = 0, external = 0, hold = 0; ///< work done on the body and in friction
  double friction = 0;                                    ///< dissipated between body and tools
  double inside = 0;        ///< work of the internal forces, where elastic and plastic parts are not known
  double elastic = 0;       ///< stored now
  double elastic_start = 0; ///< stored at the start of the run
  double plastic = 0;       ///< dissipated in the body
  double largest = 0;       ///< largest sum of the absolute works: scale of the error
  // at the end of the last step
  Eigen::VectorXd u, q, generalized_force, support_force, external_force, hold_force, internal_force;
  Eigen::VectorXd plastic_strain_eq, friction_force; ///< per point [-]; per candidate, along the slip [force]
};

/// A force or a slip that contradicts the contact, the largest of the run.
struct ViolationState {
  double value = 0; ///< [force, length]
  std::vector<double> place;
  double t = 0, first = 0;
  long count = 0; ///< steps beyond the bound, over the load of then
};

/// What the prescribed force of a coordinate was missed by, the largest of the run.
struct UnmetState {
  double missed = 0, of = 0; ///< largest difference; largest force prescribed [force, force length]
  double residual = 0,
         load = 0; ///< the difference over its lever; load of the tool, the largest ones [force]
  double t = 0;    ///< of the largest difference
};

/// How wide the contact of a tool was where it carried most, and what contradicted it.
struct WidthState {
  double load = 0; ///< largest of the run [force]
  int nodes = 0;   ///< in contact there
  std::vector<double> place;
  double t = 0;
  ViolationState tension, friction;
  long narrow = 0, steps = 0; ///< steps with few nodes, and all with contact
};

/// Two tools of the plane.
struct ToolPairState {
  Eigen::VectorXd origin; ///< of the second one in the frame of the first one [length]
  Eigen::MatrixXd R;      ///< its rotation there
  double at_start = 0;    ///< depth of their overlap at the start of the run [length]
  double clear = 0;       ///< they are apart by so much at least [length]
  bool moved = false;     ///< relative to each other
};

/// The integral of a tool's fitted pressure where it carried most.
struct PressureState {
  double load = 0; ///< sum of its normal forces there [force]
  double sum = 0;  ///< integral [force]
  double t = 0;    ///< [time]
};

struct CheckState {
  bool begun = false;
  long steps = 0; ///< looked at
  EnergyState energy;
  std::vector<WidthState> width;       ///< per tool
  std::vector<UnmetState> unmet;       ///< per coordinate
  std::vector<PressureState> pressure; ///< per tool
  std::vector<ToolPairState> pairs;    ///< of tools: (0, 1), (0, 2), (1, 2), (0, 3), ...
  /// Worst number of every check so far, by name, within its bounds or not.
  std::map<std::string, double> measured;
  bool distorted = false; ///< an element is near its bound: all are looked at in every step
  std::string stop;       ///< why the run cannot go on; "": it can
  /// Notes a number of which the largest is the worst.
  void largest(const std::string& name, double value);
  void smallest(const std::string& name, double value);
};

} // namespace burnish

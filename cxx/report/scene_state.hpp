#pragma once
// What the scene report carries from step to step. Plain data; a copy goes on to the same bits.
#include "base/types.hpp"
#include <vector>

namespace burnish {

/// How much of a tool's friction was ever needed.
struct FrictionUse {
  double largest = 0;          ///< |T| over its limit, of the nodes that carry load [-]
  long nodes = 0, sliding = 0; ///< of all steps
};

/// Where a coordinate has been.
struct CoordinateUse {
  bool forced = true; ///< under force in every step
  double least = 0, most = 0;
};

/// Largest load of a node at the end of an open contact surface, beside that of its tool.
struct EndLoad {
  double force = 0, load = 0; ///< of the node, of the tool, each the largest of the run [force]
  std::vector<double> place;
  double t = 0;
};

/// Whether the body moves as its mirror image, about the middle of one axis.
struct MirrorState {
  bool possible = true;
  long looks = 0;
  double deviation = 0; ///< of mirrored displacements over the largest one, the worst [-]
};

struct SceneState {
  long steps = 0;
  std::vector<FrictionUse> friction;      ///< per tool
  std::vector<EndLoad> ends;              ///< per tool
  std::vector<CoordinateUse> coordinates; ///< per coordinate
  std::vector<MirrorState> mirror;        ///< per axis
  std::size_t window = 0;                 ///< largest number of candidates on the dense block
  double gradient = 0;                    ///< largest |F - I| [-]
  double stress_over_yield = 0; ///< largest von Mises stress over the initial yield stress; 0: unknown
  std::vector<double> energy;   ///< per element: stored and dissipated, the largest; empty: unknown
  // where the tools carried most
  double load = 0, load_t = 0; ///< [force, time]
  std::vector<double> stress;  ///< Kirchhoff stress, as WorkpieceState::stress
};

} // namespace burnish

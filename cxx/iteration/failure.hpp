#pragma once
// Why a step has failed, as data. Words are made of it in diagnosis/words.cpp, and nowhere else.
#include <string>
#include <vector>

namespace burnish {

/// What the numbers of a Failure mean stands behind each.
enum class Cause {
  NONE,
  // found by the iteration
  INFINITE,            ///< the residual is not finite
  NO_BALANCE,          ///< forces are out of balance after the last iteration
  TOO_LITTLE_FRICTION, ///< forces balance; value: friction of all contact nodes, allowed: their limits [force]
  CYCLE,               ///< forces balance, contact states cycle
  WEDGED,              ///< the same; node, place, value: its friction, allowed: its normal force [force]
  UNSTABLE,            ///< the tangent is not positive definite
  NOT_FACTORED,        ///< a solver of general matrices has not solved with the tangent
  NOT_HELD, ///< neither supports nor the tools that touch it take all rigid motions of the workpiece
  TIPS_OVER, ///< nothing resists a motion of the tools under force; tool: no pressure balances its forces, -1: unknown
  UNRESISTED, ///< coordinate: nothing resists it; flag: no node in contact moves with it
  SINGULAR,   ///< the contact block; flag: supports leave the workpiece a rigid motion
  FORMULA,    ///< text: a formula of the coordinates has no value
  // found of a step that balances: there is no way to its end
  PASSAGE,   ///< tool, place: it passes through the workpiece within the step
  TOOL_JUMP, ///< coordinate under force, value: by how far it jumps [its own]
  BODY_JUMP, ///< value: way of the surface, allowed: way of the tools [length]; flag: on its soft hold
  // what is behind a failure
  PROGRAM_MOVES,  ///< coordinate, value: its leap, allowed: from where [its own]; t
  PROGRAM_FORCES, ///< coordinate, value: its force, allowed: that before; t
  PULLING,        ///< coordinate, value: the force that draws the tool away
  UNHELD,         ///< neither supports nor nodes in contact take all rigid motions of the workpiece
  INCOMPRESSIBLE, ///< value: K/G, allowed: nu; flag: linear elements
  EXHAUSTED, ///< coordinate, value: its largest force, allowed: where [its own], t; along: part of its way over
             ///< which the force has grown by the part `grown`; flag: its mechanism nears a dead center
  // what is said behind the failure itself
  LAST_EQUILIBRIUM, ///< t; place and force of its coordinates follow:
  EQUILIBRIUM_OF,   ///< coordinate, value: its place, allowed: its force
  END_OF_TOOL,      ///< tool, node, value: distance of the contact from the end of its profile [length]
  HANGS             ///< count: nodes in contact that alone hold the workpiece
};

/// What a residual that stays too large comes from.
enum class Residue {
  UNKNOWN,
  NO_LOAD,   ///< rounding leaves more than is allowed of a load that is next to nothing
  TOO_LARGE, ///< the same, of a mesh too large or too slender for the load
  FALLS,     ///< it still falls
  FRICTION   ///< all friction is used up
};

/// The last iteration of a step that has not converged [force].
struct LastIteration {
  int number = 0, inconsistent = 0; ///< how many were made; contact states that contradict the forces
  double residual = 0, allowed = 0, rounding = 0, load = 0;
  Residue residue = Residue::UNKNOWN;
  bool moves_on = false; ///< a tool still moves under its force
  bool lagged = false;   ///< the consistent friction tangent would need fewer iterations
};

struct Failure {
  Cause cause = Cause::NONE;
  double value = 0,
         allowed = 0; ///< the number that it rests on, and what is allowed or what it is compared with
  int coordinate = -1, node = -1, tool = -1;
  std::vector<double> place; ///< [length]
  double t = 0, along = 0, grown = 0;
  int count = 0;
  bool flag = false;
  std::string text;   ///< of somebody else, quoted
  LastIteration last; ///< NO_BALANCE to WEDGED

  Failure(Cause what = Cause::NONE) : cause(what) {}
  explicit operator bool() const { return cause != Cause::NONE; }
  /// The iteration ran out of its number.
  bool not_converged() const { return cause >= Cause::NO_BALANCE && cause <= Cause::WEDGED; }
  /// States of contact contradict the forces, however short the step: it may have no equilibrium near.
  bool states_contradict() const {
    const bool to_and_fro = cause == Cause::NO_BALANCE && last.inconsistent > 0 && !last.moves_on;
    return to_and_fro || cause == Cause::TOO_LITTLE_FRICTION || cause == Cause::CYCLE ||
           cause == Cause::WEDGED || cause == Cause::BODY_JUMP;
  }
  /// A limit load, or a loss of stability.
  bool limit_load() const {
    return cause == Cause::UNSTABLE || cause == Cause::TOOL_JUMP || (not_converged() && last.moves_on);
  }
};

} // namespace burnish

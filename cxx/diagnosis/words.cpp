#include "diagnosis/words.hpp"
#include "base/sentence.hpp"

namespace burnish {
namespace {

std::string words(const LastIteration& last) {
  switch (last.residue) {
  case Residue::NO_LOAD:
    return sentence(
        ": rounding leaves up to ", last.rounding, ", the load of ", last.load,
        " is next to nothing: look at its size and units; where nothing presses the workpiece yet, "
        "C.hold(stiffness, until) holds it until something does");
  case Residue::TOO_LARGE:
    return sentence(": rounding leaves up to ", last.rounding,
                    ", the mesh is too large or too slender for this load");
  case Residue::FALLS:
    return ": the residual still falls, allow more iterations (maxiterations=)";
  case Residue::FRICTION:
    return ": all friction is used up, nothing is left for a coordinate under force";
  case Residue::UNKNOWN:
    break;
  }
  return last.inconsistent > 0 && !last.moves_on ? ": states go to and fro, and none of them agree with "
                                                   "their forces: shorter steps, or a finer surface, may help"
                                                 : "";
}

std::string not_converged(const Failure& f) {
  const LastIteration& last = f.last;
  std::string text =
      sentence("no convergence in ", last.number, " iterations: residual ", last.residual, ", allowed ",
               last.allowed, ", ", last.inconsistent, " inconsistent contact states");
  if (f.cause == Cause::NO_BALANCE) {
    text += words(last);
    if (last.moves_on)
      text += std::string(last.residue == Residue::UNKNOWN ? ": " : "; ") +
              "the tool goes on moving under its force, a limit load";
  } else if (f.cause == Cause::TOO_LITTLE_FRICTION) {
    text += sentence(": the forces balance with friction that adds up to ", f.value,
                     " over the contact nodes, whose limits add up to ", f.allowed,
                     ": too little to balance a coordinate under force, or a sheet slips from node to node");
  } else {
    text += ": the forces balance, but states cycle";
  }
  if (f.cause == Cause::WEDGED)
    text += sentence(": node ", f.node, " at ", place_text(f.place),
                     " can neither stick nor slide, since its friction of ", f.value,
                     " beside a normal force of ", f.allowed, " is so large that it wedges");
  if (f.cause == Cause::CYCLE || f.cause == Cause::WEDGED)
    text += ": there may be no equilibrium near the last one";
  if (last.lagged) text += "; frictiontangent=\"consistent\" needs fewer iterations";
  return text;
}

std::string exhausted(const Failure& f, const std::string& coordinate) {
  return sentence("nothing balances more than the force ", f.value, " of ", coordinate, ", reached at ",
                  f.allowed, ", t = ", f.t, ": over the last ", 100 * f.along,
                  " % of its way this force has grown by ", 100 * f.grown,
                  " %, a limit load beyond which it runs through; ",
                  f.flag ? "the contact force still grows, but its mechanism nears a dead center"
                         : "the workpiece gives way",
                  ": prescribe the motion instead, or less force");
}

// Behind what was found, not in front of it.
bool is_behind(Cause cause) { return cause >= Cause::LAST_EQUILIBRIUM; }

} // namespace

template <int Dim> std::string words(const Failure& f, const ContactModel<Dim>& model) {
  const std::string coordinate = f.coordinate >= 0 ? model.coordinate(f.coordinate) : "";
  const std::string tool = f.tool >= 0 ? "tool \"" + model.tools[f.tool]->name() + "\"" : "";
  switch (f.cause) {
  case Cause::NONE:
    return "";
  case Cause::INFINITE:
    return "the residual is not finite";
  case Cause::NO_BALANCE:
  case Cause::TOO_LITTLE_FRICTION:
  case Cause::CYCLE:
  case Cause::WEDGED:
    return not_converged(f);
  case Cause::UNSTABLE:
    return "the tangent is not positive definite: loss of stability or limit load";
  case Cause::NOT_FACTORED:
    return "the solver has not solved with the tangent, which is singular to it";
  case Cause::NOT_HELD:
    return "the workpiece is not held: neither supports (fixed=) nor the tools that touch it take all its "
           "rigid motions; soft springs do: contact.hold";
  case Cause::TIPS_OVER:
    return f.tool >= 0
               ? "no pressure on the nodes near " + tool +
                     " balances the forces on it: it tips over or rolls away"
               : "nothing resists a motion of the tools under force control: a tool tips over or rolls away";
  case Cause::UNRESISTED:
    return "nothing resists " + coordinate + " under force control" +
           (f.flag ? ": no node in contact moves with it" : "");
  case Cause::SINGULAR:
    return f.flag ? "singular contact block: neither supports nor tools constrain the workpiece"
                  : "singular contact block";
  case Cause::FORMULA:
    return f.text;
  case Cause::PASSAGE:
    return sentence(tool, " passes through the workpiece in one step: at ", place_text(f.place),
                    " the contact surface is outside of it before and after and inside on the way");
  case Cause::TOOL_JUMP:
    return sentence(coordinate, " under force jumps by ", f.value,
                    ": there is no equilibrium near the last one, a limit load");
  case Cause::BODY_JUMP:
    return sentence("the workpiece", f.flag ? " on its soft hold" : ", which no support holds,", " jumps by ",
                    f.value, " while the tools move by ", f.allowed, ": there is no way there");
  case Cause::PROGRAM_MOVES:
    return sentence("the program moves ", coordinate, " by ", f.value, " at once, from ", f.allowed,
                    " at t = ", f.t, ": after a force go on from value(...)");
  case Cause::PROGRAM_FORCES:
    return sentence("the program changes the force on ", coordinate, " from ", f.allowed, " to ", f.value,
                    " at once at t = ", f.t, ": let it change over some time");
  case Cause::PULLING:
    return sentence("the force ", f.value, " on ", coordinate,
                    " draws the tool away from the workpiece, which only pushes");
  case Cause::UNHELD:
    return "the workpiece is not held: neither supports (fixed=) nor the nodes in contact take all its rigid "
           "motions; soft springs do: contact.hold";
  case Cause::INCOMPRESSIBLE:
    return sentence("the workpiece is nearly incompressible, its bulk modulus ", f.value,
                    " times its shear modulus (nu = ", f.allowed,
                    "): small errors of the volume are large stresses; take nu up to 0.49",
                    f.flag ? ", and P2, since P1 locks" : "");
  case Cause::EXHAUSTED:
    return exhausted(f, coordinate);
  case Cause::LAST_EQUILIBRIUM:
    return sentence("; the last equilibrium is that of t = ", f.t);
  case Cause::EQUILIBRIUM_OF:
    return sentence(", ", coordinate, " = ", f.value, " with force ", f.allowed);
  case Cause::END_OF_TOOL:
    return sentence("; node ", f.node, " in contact is ", f.value, " from the end of the profile of ", tool,
                    ", where the contact ends with a jump: let the profile go on and curve away from the "
                    "workpiece (chain= with a fillet)");
  case Cause::HANGS:
    break;
  }
  return sentence("; the workpiece, to which supports leave a rigid motion, hangs on ", f.count,
                  f.count == 1 ? " node" : " nodes",
                  " in contact and may slip from one to the next: a holder, another support, or a finer mesh "
                  "there");
}

template <int Dim>
std::string words(const Failure& found, const std::vector<Failure>& causes, const std::string& refusal,
                  const ContactModel<Dim>& model) {
  std::string text = words(found, model);
  const Failure* first = nullptr;
  for (const Failure& cause : causes)
    if (!first && !is_behind(cause.cause)) first = &cause;
  if (first) {
    const bool same = !found || (found.cause == Cause::NOT_HELD && first->cause == Cause::UNHELD);
    text = words(*first, model) + (same ? "" : " (" + text + ")");
  } else if (found) {
    for (const Failure& cause : causes) text += words(cause, model);
  }
  if (refusal.empty() || text.empty()) return text + refusal;
  return text + " (" + refusal + ")";
}

template std::string words<2>(const Failure&, const ContactModel<2>&);
template std::string words<3>(const Failure&, const ContactModel<3>&);
template std::string words<2>(const Failure&, const std::vector<Failure>&, const std::string&,
                              const ContactModel<2>&);
template std::string words<3>(const Failure&, const std::vector<Failure>&, const std::string&,
                              const ContactModel<3>&);

} // namespace burnish

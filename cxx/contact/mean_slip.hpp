#pragma once
// A slip that turns lies along the mean of its directions at the start and at the end of a step: METHOD.md (3.14g), (3.14h). In space.
#include "contact/contact_model.hpp"

namespace burnish {

/// The c of METHOD.md (3.14) is this part of the median stiffness of the candidates, kappa.
inline constexpr double SLIP_STIFFNESS = 0.05;

/// The slip D of a step turned into its direction at the end, D*, and the derivative of D* by D.
template <int Dim> struct MeanSlip {
  Param<Dim> way;         ///< as long as D [length]
  Curvature<Dim> by_slip; ///< [-]
};
/// @param slip D [length]; @param memory w m0 of (3.14g), in the same tangents, not longer than 1; zero: D* = D
template <int Dim> MeanSlip<Dim> mean_slip(const Param<Dim>& slip, const Param<Dim>& memory);

/// The same of a node that slides, with its slip_memory; D* = D in the plane.
/// @param fixed states stay through the step: D* = D also of a slip that has turned by more than 60 degrees, as one that goes back does
template <int Dim>
MeanSlip<Dim> mean_slip_of(const ContactModel<Dim>& model, const ContactNode<Dim>& node, double tool_size,
                           bool fixed);

/// Weight w of the direction m0 in the next step, METHOD.md (3.14h).
/// @param slip its length [length]; @param g of the node [force]; @param c of ContactState [force/length]
inline double slip_memory(double slip, double g, double c) {
  const double own = c / SLIP_STIFFNESS * slip;
  return g > 0 ? g * g / (g * g + own * own) : 0;
}

} // namespace burnish

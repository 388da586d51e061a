#pragma once
// The slip of a step in space lies along the mean of its directions at the start and at the end: METHOD.md (3.14g), (3.14h).
#include "contact/contact_model.hpp"

namespace burnish {

/// The c of METHOD.md (3.14) is this part of the stiffness of a node.
inline constexpr double SLIP_STIFFNESS = 0.05;

/// A slip D turned into the direction that it asks for at its end, D*, and the derivative of D* by D.
template <int Dim> struct MeanSlip {
  Param<Dim> way;         ///< as long as D [length]
  Curvature<Dim> by_slip; ///< [-]
};
/// @param slip   D of the step [length]; @param before direction at its start, a unit vector; zero: D* = D
/// @param reach  slip over which a direction forgets the one before, the g/kappa of (3.14h) [length]
template <int Dim> MeanSlip<Dim> mean_slip(const Param<Dim>& slip, const Param<Dim>& before, double reach);

/// The same of a node that slides, with its slip_before; D* = D in the plane, of a node that began to slide in this step, and
/// where nothing turns. @param c of ContactState [force/length]
template <int Dim>
MeanSlip<Dim> mean_slip_of(const ContactModel<Dim>& model, int candidate, const ContactNode<Dim>& node,
                           const DecidingForce<Dim>& deciding, double c);

} // namespace burnish

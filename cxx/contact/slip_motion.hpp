#pragma once
// Slips of a whole contact state: what a step made of them, and steps that are linear in them.
#include "contact/condensation.hpp"

namespace burnish {

/// Slip rates of a step of length dt; the directions of slip become those in the tangents where the nodes are now.
/// @param R internal minus external nodal force, num_dofs: says what they keep of them in the next step (mean_slip.hpp) [force]
template <int Dim>
void measure_slips(const ContactModel<Dim>& model, double dt, const Eigen::VectorXd& R,
                   ContactState<Dim>& state);

/// Places moved by the slips of a solution, and the coordinates by its increments.
template <int Dim>
void move_by(const ContactModel<Dim>& model, const typename Condensation<Dim>::Expansion& increment,
             ContactState<Dim>& state);

/// State at the fraction of a step that is linear: slips and coordinates. @param end in: at its end; out: there
template <int Dim>
void shorten(const ContactModel<Dim>& model, const ContactState<Dim>& start, double fraction,
             ContactState<Dim>& end);

/// Speed of the contact along the body: tangential motion of the contact nodes with their tool's carrier, from the
/// coordinates q_old in the time dt [length/time].
template <int Dim>
double contact_speed(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                     const Eigen::VectorXd& q_old, double dt);

/// Motions of the contact nodes of a tool with its carrier, along the tool, from the coordinates q_old on.
struct ContactWay {
  Vector<3> sum = Vector<3>::Zero(); ///< of all of them [length]
  double length = 0;                 ///< sum of their lengths [length]
};
ContactWay contact_way(const ContactModel<3>& model, const ContactState<3>& state,
                       const Eigen::VectorXd& q_old, int tool);

} // namespace burnish

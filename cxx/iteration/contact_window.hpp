#pragma once
// The window of candidates that the factor keeps on its dense block: those in contact and those near it.
#include "contact/body_view.hpp"
#include "contact/contact_model.hpp"
#include "iteration/options.hpp"

namespace burnish {

/// Extent of the contact of a tool: in the plane the distance between its outermost contact nodes; in space along the motion
/// of the contact with its tool's carrier, where that has none the smaller one of the contact's principal directions
/// [length]. @param q_old all coordinates at the start of the last step; read in space only, there it may be empty
template <int Dim>
double contact_width(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                     const ContactState<Dim>& state, const Eigen::VectorXd& u, int tool,
                     const Eigen::VectorXd& q_old);

/// Extent of some places: in the plane their diameter, in space the middle one of their three principal directions: of
/// places on a surface the smaller one along it; 0 for fewer than two [length].
template <int Dim> double least_width(const std::vector<Vector<Dim>>& places);

/// Candidates within a distance of the contact of each tool, or of its closest free node where nothing is in contact;
/// and those that penetrate.
/// @param part of the margin of the window, four spacings of the nodes
/// @returns candidate numbers, ascending
template <int Dim>
std::vector<int> near_contact(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                              const ContactState<Dim>& state, const Eigen::VectorXd& u, double part,
                              const IterationOptions& options);

/// The window's part among all nodes.
template <int Dim>
Eigen::VectorXd scatter_window(const ContactModel<Dim>& model, const std::vector<int>& window,
                               const Eigen::VectorXd& part, Eigen::Index size);

} // namespace burnish

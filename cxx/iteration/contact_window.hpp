#pragma once
// The window of candidates that the factor keeps on its dense block: those in contact and those near it.
#include "contact/body_view.hpp"
#include "contact/contact_model.hpp"
#include "iteration/options.hpp"

namespace burnish {

/// Extent of the contact of a tool: distance between its outermost contact nodes [length].
template <int Dim>
double contact_width(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                     const ContactState<Dim>& state, const Eigen::VectorXd& u, int tool);

/// Candidates within a distance of the contact of each tool, or of its closest free node where nothing is in contact;
/// and those that penetrate.
/// @param part of the margin of the window: three quarters of the contact width of the tool plus six spacings
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

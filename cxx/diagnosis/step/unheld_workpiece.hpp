#pragma once
// Whether the nodes in contact hold a workpiece that its supports do not.
#include "contact/contact_setup.hpp"

namespace burnish {

/// Supports leave the workpiece a rigid motion that the nodes in contact do not take either, the tools at rest.
template <int Dim>
bool unheld(const ContactSetup<Dim>& setup, const ContactState<Dim>& state, const Eigen::VectorXd& u);

} // namespace burnish

#pragma once
// A contact under way on a new mesh of its workpiece: the same tools where they are, the same surface by its labels
// (ALGORITHMS.md 19.3).
#include "run/contact_run.hpp"

namespace burnish {

/// The contact problem on a new mesh: surface by the labels of the old one, its tools with their laws, reaches and couplings.
/// @param fixed num_dofs flags of the new mesh: displacement is given
/// @throws std::invalid_argument if a label of the contact is not on the new mesh
template <int Dim>
std::shared_ptr<ContactSetup<Dim>> setup_on(const ContactSetup<Dim>& old, Mesh<Dim> mesh,
                                            std::vector<char> fixed);

/// State of the contact on the new mesh, between steps. A candidate is in contact where the old one nearest to it was and the
/// tool is not farther than a fiftieth of the spacing, and sticks or slides as that one. Supports and a soft hold go on as they are;
/// external forces are to be given anew.
/// @param fresh run on the new mesh; @param start its displacement; @param du of the last step there [length]
/// @throws std::invalid_argument as supports_on
template <int Dim>
ContactRunState<Dim> contact_state_on(const ContactRun<Dim>& old, const ContactRun<Dim>& fresh,
                                      const Eigen::VectorXd& start, const Eigen::VectorXd& du);

} // namespace burnish

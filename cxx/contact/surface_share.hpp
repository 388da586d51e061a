#pragma once
// The share of the contact surface that belongs to a node: what turns nodal forces into tractions.
#include "contact/body_view.hpp"
#include "contact/contact_model.hpp"
#include "mesh/mesh.hpp"

namespace burnish {

/// Integrals of N_i phi_j dA over an edge in its present place: N_i the shape functions of the nodes a, b and
/// middle, phi_j the linear functions of a and b; dA = dl, or 2 pi r dl when axisymmetric (r = x).
using EdgeMasses = Eigen::Matrix<double, 3, 2>;
EdgeMasses edge_masses(const BodyView<2>& body, const Facet<2>& edge, const Eigen::VectorXd& u);

/// Integral of each candidate's shape function over the edges in their present place: in the plane 1/2 : 1/2
/// of a linear edge, 1/6 : 2/3 : 1/6 of a quadratic one. @param u displacement, num_dofs [length]
/// @return one per candidate [length; axisymmetric: area of the ring]
template <int Dim>
Eigen::VectorXd surface_shares(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                               const std::vector<Facet<2>>& edges, const Eigen::VectorXd& u);

} // namespace burnish

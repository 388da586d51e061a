#pragma once
// The tributary area of a node of the contact surface: what turns nodal forces into tractions.
#include "contact/body_view.hpp"
#include "contact/contact_model.hpp"

namespace burnish {

/// Share of the largest tributary area below which a node has none but for rounding: a vertex on the axis of quadratic
/// elements.
inline constexpr double NO_AREA = 1e-9;

/// Present places of a facet's nodes, for FacetMeasure.
template <int Dim>
std::vector<Vector<Dim>> places_of(const BodyView<Dim>& body, const Facet<Dim>& facet,
                                   const Eigen::VectorXd& u);

/// Integral of each candidate's shape function over the facets in their present place: in the plane 1/2 : 1/2
/// of a linear edge, 1/6 : 2/3 : 1/6 of a quadratic one. @param u displacement, num_dofs [length]
/// @return one per candidate [length in the plane; area in space and of whole rings]
template <int Dim>
Eigen::VectorXd tributary_areas(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                const std::vector<Facet<Dim>>& facets, const Eigen::VectorXd& u);

} // namespace burnish

#pragma once
// Resultants of nodal forces: what supports and tools exert on the workpiece (METHOD.md 3.14).
#include "contact/body_view.hpp"
#include "contact/contact_model.hpp"

namespace burnish {

/// Force and moment of nodal forces about a point.
template <int Dim> struct Resultant {
  using Moment = Eigen::Matrix<double, Dim*(Dim - 1) / 2, 1>;
  Vector<Dim> force = Vector<Dim>::Zero(); ///< [force]
  Moment moment = Moment::Zero();          ///< in the plane one number, counter-clockwise [force length]
  Resultant& operator+=(const Resultant& other);
};

/// Resultant of nodal forces that act on the nodes where these are now, METHOD.md (3.16).
/// @param u     displacement, num_dofs [length]
/// @param f     nodal forces, num_dofs [force]
/// @param about the point of the moment [length]
/// @param nodes only these; empty: all
template <int Dim>
Resultant<Dim> resultant(const BodyView<Dim>& body, const Eigen::VectorXd& u, const Eigen::VectorXd& f,
                         const Vector<Dim>& about, const std::vector<int>& nodes = {});
/// The same for the whole ring of an axisymmetric body: radial forces have no resultant and no moment, only the axial
/// component remains.
template <int Dim> Resultant<Dim> of_ring(const Resultant<Dim>& section);

/// Forces of the tools on the nodes of the workpiece, num_dofs, 0 where there is no contact [force]. A node that an
/// event has just released still has its force.
/// @param R    internal minus external nodal force [force]
/// @param tool only those of this one; -1: of all
template <int Dim>
Eigen::VectorXd contact_forces(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                               const Eigen::VectorXd& R, int tool = -1);
/// Forces of the supports on the nodes of the workpiece, num_dofs, 0 at free components: what the given components need
/// beside the tools [force].
template <int Dim>
Eigen::VectorXd support_forces(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                               const ContactState<Dim>& state, const Eigen::VectorXd& R);

} // namespace burnish

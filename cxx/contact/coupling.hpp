#pragma once
// Coordinates that follow others, q_d = f(q): they are eliminated, METHOD.md 2.6, 3.13.
#include "contact/linearization.hpp"

namespace burnish {

/// "tool.coordinate" of every coordinate of a contact, in the order of q.
template <int Dim> std::vector<std::string> dotted_names(const ContactModel<Dim>& model);

/// @param dependent "tool.coordinate" that follows
/// @param text      formula in the other coordinates, each called "tool.coordinate"; messages show them with
///                  underscores, as the formula engine reads them
/// @throws std::invalid_argument for names that no tool has (lists the known ones), a relation to itself or to no
/// coordinate at all, a chain: a coordinate that follows one that follows itself; and for what Formula refuses
template <int Dim>
Coupling make_coupling(const ContactModel<Dim>& model, const std::string& dependent, const std::string& text);

/// Puts the coordinates that follow where they belong.
/// @throws FormulaDomainError where a relation has no finite value
template <int Dim> void follow(const ContactModel<Dim>& model, Eigen::VectorXd& q);

/// df/dq^i of a coupling's arguments at q, in their order.
Eigen::VectorXd slopes_of(const Coupling& coupling, const Eigen::VectorXd& q);

/// The increments of the coordinates that follow from those of the others, dq_d = f_,i dq^i; in: anything there.
template <int Dim>
void follow_increment(const ContactModel<Dim>& model, const Eigen::VectorXd& q, Eigen::VectorXd& dq);

/// Virtual work hands the forces conjugate to coordinates that follow on to what they follow, Q_i += f_,i Q_d. Those of
/// the coordinates that follow stay as they are.
/// @param force one per coordinate [work over coordinate]
template <int Dim>
void pass_on_forces(const ContactModel<Dim>& model, const Eigen::VectorXd& q, Eigen::VectorXd& force);

/// Takes the coordinates that follow out of the linearization of a node, METHOD.md (3.15): `at`, x_q and the geometric
/// terms are those of independent coordinates then, with second derivatives of the relations if the terms are COMPLETE.
template <int Dim>
void eliminate_followers(const ContactModel<Dim>& model, const Eigen::VectorXd& q, GeometricTerms terms,
                         NodeLinearization<Dim>& node);

} // namespace burnish

#pragma once
// Between FreeFEM's matrices and the core's.
#include "contact/condensation.hpp"
#include "plugin.hpp"
#include "workpiece/workpiece.hpp"

namespace rigidcontact {

burnish::TangentKind tangent_kind(const std::string& name);
/// View of a square FreeFEM matrix. @throws std::invalid_argument if it is empty or not square
burnish::TripletView view_of(Matrice_Creuse<double>* matrix, const char* where);
/// New FreeFEM matrix with our solver attached, so that K^-1*b works without set().
newpMatrice_Creuse<double> to_freefem(Stack stack, const burnish::CondensedSystem& system);
/// The same from the symmetric tangent: lower triangle.
newpMatrice_Creuse<double> to_freefem(Stack stack, const burnish::NodeBlockMatrix<2>& K);

} // namespace rigidcontact

#pragma once
// Between FreeFEM's matrices and the core's.
#include "contact/condensation.hpp"
#include "plugin.hpp"
#include "solver/sparse_view.hpp"
#include "workpiece/workpiece.hpp"

namespace burnish {

TangentKind tangent_kind(const std::string& name);
/// Largest asymmetry of a script's tangent where a symmetric one is needed, over its largest entry.
constexpr double LARGEST_ASYMMETRY = 1e-6;
/// View of an n x n FreeFEM matrix. @throws std::invalid_argument if it is empty, not square or of another
/// size
TripletView view_of(Matrice_Creuse<double>* matrix, long n, const char* where);
/// The name in capitals. @throws std::invalid_argument listing the solvers loaded if it is none of them
std::string known_solver(const std::string& name, const char* where);
/// FreeFEM's matrix with its entries in the order that the solver reads: UMFPACK by columns, the others by rows; FreeFEM sorts
/// slowly. @param place out: of every entry of `rows`, its place there; empty: the same order
std::unique_ptr<HashMatrix<int, double>> sorted_matrix(const SparseView& rows, const std::string& solver,
                                                       std::vector<int>& place);
/// New FreeFEM matrix with a solver attached, so that K^-1*b works without set().
newpMatrice_Creuse<double> to_freefem(Stack stack, const CondensedSystem& system,
                                      const std::string& solver = "BURNISH");
/// The same from a tangent: lower triangle of a symmetric one, or all of it.
template <int Dim>
newpMatrice_Creuse<double> to_freefem(Stack stack, const NodeBlockMatrix<Dim>& K, bool full);

} // namespace burnish

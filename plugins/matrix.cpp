#include "matrix.hpp"
#include "base/error.hpp"
#include "solver/sparse_rows.hpp"

namespace burnish {

TripletView view_of(Matrice_Creuse<double>* matrix, long n, const char* where) {
  HashMatrix<int, double>* A = matrix ? matrix->pHM() : nullptr;
  if (!A || A->n != A->m) fail(where, "K is empty or not square");
  require(A->n == n, where, "size of K", A->n,
          (std::to_string(n) + ", the number of degrees of freedom").c_str());
  return {A->n, A->nnz, A->i, A->j, A->aij, A->half != 0};
}

std::unique_ptr<HashMatrix<int, double>> sorted_matrix(const SparseView& rows, const std::string& solver,
                                                       std::vector<int>& place) {
  const int nnz = rows.row_start[rows.n];
  auto A = std::make_unique<HashMatrix<int, double>>(rows.n, rows.n, nnz, rows.symmetric ? 1 : 0);
  const bool by_columns = solver == "UMFPACK";
  place = by_columns ? places_by_columns(rows) : std::vector<int>();
  for (int row = 0; row < rows.n; ++row)
    for (int k = rows.row_start[row]; k < rows.row_start[row + 1]; ++k) {
      const int at = by_columns ? place[k] : k;
      A->i[at] = row;
      A->j[at] = rows.col[k];
      A->aij[at] = rows.value[k];
    }
  A->nnz = nnz;
  A->ReHash();
  A->state = by_columns ? HashMatrix<int, double>::sorted_ji : HashMatrix<int, double>::sorted_ij;
  A->type_state = HashMatrix<int, double>::type_COO;
  A->re_do_numerics = A->re_do_symbolic = 1;
  return A;
}

static newpMatrice_Creuse<double> to_freefem(Stack stack, const SparseView& rows, const std::string& solver) {
  std::vector<int> place;
  auto A = sorted_matrix(rows, solver, place);
  Data_Sparse_Solver options;
  options.solver = solver;
  options.sym = rows.symmetric;
  SetSolver<double>(stack, false, *A, options);
  return newpMatrice_Creuse<double>(stack, A.release());
}

newpMatrice_Creuse<double> to_freefem(Stack stack, const CondensedSystem& system, const std::string& solver) {
  return to_freefem(stack,
                    {system.n, system.row_start.data(), system.col.data(), system.value.data(), system.half},
                    solver);
}

template <int Dim>
newpMatrice_Creuse<double> to_freefem(Stack stack, const NodeBlockMatrix<Dim>& K, bool full) {
  return to_freefem(stack, (full ? all_rows(K) : lower_triangle(K)).view(), "BURNISH");
}
template newpMatrice_Creuse<double> to_freefem(Stack, const NodeBlockMatrix<2>&, bool);
template newpMatrice_Creuse<double> to_freefem(Stack, const NodeBlockMatrix<3>&, bool);

} // namespace burnish

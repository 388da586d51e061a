#include "matrix.hpp"
#include "base/error.hpp"

namespace burnish {

TripletView view_of(Matrice_Creuse<double>* matrix, long n, const char* where) {
  HashMatrix<int, double>* A = matrix ? matrix->pHM() : nullptr;
  if (!A || A->n != A->m) fail(where, "K is empty or not square");
  require(A->n == n, where, "size of K", A->n,
          (std::to_string(n) + ", the number of degrees of freedom").c_str());
  return {A->n, A->nnz, A->i, A->j, A->aij, A->half != 0};
}

newpMatrice_Creuse<double> to_freefem(Stack stack, const CondensedSystem& system, const std::string& solver) {
  const int nnz = static_cast<int>(system.col.size());
  auto* A = new HashMatrix<int, double>(system.n, system.n, nnz, system.half ? 1 : 0);
  for (int row = 0; row < system.n; ++row)
    for (int k = system.row_start[row]; k < system.row_start[row + 1]; ++k) {
      A->i[k] = row;
      A->j[k] = system.col[k];
      A->aij[k] = system.value[k];
    }
  A->nnz = nnz;
  A->ReHash();
  A->state = HashMatrix<int, double>::sorted_ij;
  A->type_state = HashMatrix<int, double>::type_COO;
  A->re_do_numerics = A->re_do_symbolic = 1;
  Data_Sparse_Solver options;
  options.solver = solver;
  options.sym = system.half;
  SetSolver<double>(stack, false, *A, options);
  return newpMatrice_Creuse<double>(stack, A);
}

newpMatrice_Creuse<double> to_freefem(Stack stack, const NodeBlockMatrix<2>& K) {
  CondensedSystem lower;
  lower.n = K.size();
  lower.half = true;
  lower.row_start.push_back(0);
  for (int row = 0; row < K.size(); ++row) {
    for (int k = K.row_start[row / 2]; k < K.row_start[row / 2 + 1]; ++k)
      for (int c = 0; c < 2 && 2 * K.col[k] + c <= row; ++c) {
        lower.col.push_back(2 * K.col[k] + c);
        lower.value.push_back(K.block(k)[2 * (row % 2) + c]);
      }
    lower.row_start.push_back(static_cast<int>(lower.col.size()));
  }
  return to_freefem(stack, lower);
}

} // namespace burnish

// Registers the solver "BURNISH" with FreeFEM: set(Khat, solver="BURNISH"). Symmetric part by CHOLMOD, the nonsymmetric
// contact rows as a dense border, UMFPACK where that does not apply. Values changed in place are noticed.
//   rcSolver(name)   the name in capitals if there is such a solver; FreeFEM itself takes any name silently
//     name      "BURNISH", "UMFPACK", "CHOLMOD", ... | | | a solver that is loaded
//     > set(Khat, solver=rcSolver("MUMPS"));
//     ! unknown solver
#include "base/error.hpp"
#include "matrix.hpp"

#include "VirtualSolver.hpp"
#include "solver/condensed_solver.hpp"
#include "solver/sparse_rows.hpp"
#include <algorithm>

namespace burnish {
namespace {

SolverPool& pool() {
  static SolverPool solvers;
  return solvers;
}

class BurnishSolver : public VirtualSolver<int, double> {
public:
  static const int orTypeSol = 1 | 2 | 4 | 8 | 16 | 32;
  BurnishSolver(HashMatrix<int, double>& A, const Data_Sparse_Solver&, Stack)
      : m_A(A), m_solver(pool().take()) {}
  ~BurnishSolver() override { pool().give_back(std::move(m_solver)); }
  void factorize(int state) override {
    const bool numerics = m_A.GetReDoNumerics(), symbolic = m_A.GetReDoSymbolic();
    if (state < 3 || (m_done && !numerics && !symbolic)) return;
    guarded([&] {
      const SparseRows rows = rows_of({m_A.n, m_A.nnz, m_A.i, m_A.j, m_A.aij, m_A.half != 0});
      if (m_solver->factorize(rows.view()) != FactorStatus::OK)
        throw std::runtime_error("solver BURNISH: the matrix is singular");
    });
    m_done = true;
  }
  void dosolver(double* x, double* b, int columns, int transposed) override {
    guarded([&] {
      for (int c = 0; c < columns; ++c) {
        const Eigen::VectorXd right = Eigen::Map<Eigen::VectorXd>(b + static_cast<long>(c) * m_A.n, m_A.n);
        Eigen::Map<Eigen::VectorXd>(x + static_cast<long>(c) * m_A.n, m_A.n) =
            m_solver->solve(right, transposed != 0);
      }
    });
  }

private:
  HashMatrix<int, double>& m_A;
  std::unique_ptr<CondensedSolver> m_solver;
  bool m_done = false;
};

string* checked_solver(Stack stack, string* const& name) {
  return guarded([&] { return new_string(stack, known_solver(*name, "rcSolver")); });
}

} // namespace

std::string known_solver(const std::string& name, const char* where) {
  std::string upper = name, list;
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  for (const auto& solver : TheFFSolver<int, double>::ffsolver) {
    if (solver.first == upper) return upper;
    list += (list.empty() ? "" : ", ") + solver.first;
  }
  fail(where, "unknown solver \"" + name + "\", expected one of " + list +
                  " (others after load, such as \"MUMPS_seq\")");
}

void register_solver() {
  addsolver<BurnishSolver>("BURNISH", 50);
  Global.Add("rcSolver", "(", new OneOperator1s_<string*, string*>(checked_solver));
}

} // namespace burnish

// Registers the solver "BURNISH": set(Khat, solver="BURNISH"). Symmetric part by CHOLMOD, the nonsymmetric
// contact rows as a dense border, UMFPACK where that does not apply. Values changed in place are noticed.
// rcSolver("NAME") gives the name back if there is such a solver; FreeFEM itself takes any name silently:
//   set(Khat, solver=rcSolver("MUMPS"));
#include "base/error.hpp"
#include "matrix.hpp"

#include "VirtualSolver.hpp"
#include "solver/bordered_solver.hpp"
#include "solver/unsymmetric_solver.hpp"
#include <algorithm>

namespace burnish {
namespace {

// Compressed rows of a FreeFEM matrix, whatever the order of its entries.
struct Rows {
  std::vector<int> row_start, col;
  std::vector<double> value;
  explicit Rows(const HashMatrix<int, double>& A) : row_start(A.n + 1, 0), col(A.nnz), value(A.nnz) {
    for (std::size_t k = 0; k < A.nnz; ++k) ++row_start[A.i[k] + 1];
    for (int r = 0; r < A.n; ++r) row_start[r + 1] += row_start[r];
    std::vector<int> next(row_start.begin(), row_start.end() - 1);
    std::vector<std::size_t> order(A.nnz);
    for (std::size_t k = 0; k < A.nnz; ++k) order[next[A.i[k]]++] = k;
    for (int r = 0; r < A.n; ++r) {
      std::sort(order.begin() + row_start[r], order.begin() + row_start[r + 1],
                [&](std::size_t a, std::size_t b) { return A.j[a] < A.j[b]; });
      for (int k = row_start[r]; k < row_start[r + 1]; ++k) {
        col[k] = A.j[order[k]];
        value[k] = A.aij[order[k]];
      }
    }
  }
  SparseView view(int n, bool half) const { return {n, row_start.data(), col.data(), value.data(), half}; }
};

// Solvers with their analysis outlive FreeFEM's objects, which are made anew at every set(): a small pool.
struct Pair {
  BorderedSolver bordered;
  UnsymmetricSolver general;
};
std::vector<std::unique_ptr<Pair>>& pool() {
  static std::vector<std::unique_ptr<Pair>> solvers;
  return solvers;
}

class BurnishSolver : public VirtualSolver<int, double> {
public:
  static const int orTypeSol = 1 | 2 | 4 | 8 | 16 | 32;
  BurnishSolver(HashMatrix<int, double>& A, const Data_Sparse_Solver&, Stack) : m_A(A) {
    if (pool().empty())
      m_pair = std::make_unique<Pair>();
    else {
      m_pair = std::move(pool().back());
      pool().pop_back();
    }
  }
  ~BurnishSolver() override {
    if (pool().size() < 4) pool().push_back(std::move(m_pair));
  }
  void factorize(int state) override {
    const bool numerics = m_A.GetReDoNumerics(), symbolic = m_A.GetReDoSymbolic();
    if (state < 3 || (m_done && !numerics && !symbolic)) return;
    guarded([&] {
      const Rows rows(m_A);
      const auto view = rows.view(m_A.n, m_A.half != 0);
      m_bordered = m_pair->bordered.factorize(view) == FactorStatus::OK;
      if (!m_bordered && m_pair->general.factorize(view) != FactorStatus::OK)
        throw std::runtime_error("solver BURNISH: the matrix is singular");
    });
    m_done = true;
  }
  void dosolver(double* x, double* b, int columns, int transposed) override {
    guarded([&] {
      for (int c = 0; c < columns; ++c) {
        const Eigen::VectorXd right = Eigen::Map<Eigen::VectorXd>(b + static_cast<long>(c) * m_A.n, m_A.n);
        Eigen::Map<Eigen::VectorXd> left(x + static_cast<long>(c) * m_A.n, m_A.n);
        if (m_bordered)
          left = transposed ? m_pair->bordered.solve_transposed(right) : m_pair->bordered.solve(right);
        else
          left = transposed ? m_pair->general.solve_transposed(right) : m_pair->general.solve(right);
      }
    });
  }

private:
  HashMatrix<int, double>& m_A;
  std::unique_ptr<Pair> m_pair;
  bool m_done = false, m_bordered = false;
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

// Solvers of FreeFEM for the core: UMFPACK, CHOLMOD, MUMPS where it is loaded, and the others.
#include "freefem_solver.hpp"
#include "matrix.hpp"

#include "VirtualSolver.hpp"
#include "solver/umfpack_solver.hpp"
#include <suitesparse/SuiteSparse_config.h>
#include <typeinfo>

namespace burnish {
namespace {

/// While it lives, neither FreeFEM nor SuiteSparse prints: what they would say is said by the core.
class QuietLibraries {
public:
  QuietLibraries() : m_buffer(std::cout.rdbuf(nullptr)), m_print(SuiteSparse_config.printf_func) {
    SuiteSparse_config.printf_func = nullptr;
  }
  ~QuietLibraries() {
    std::cout.rdbuf(m_buffer);
    std::cout.clear();
    SuiteSparse_config.printf_func = m_print;
  }
  QuietLibraries(const QuietLibraries&) = delete;
  QuietLibraries& operator=(const QuietLibraries&) = delete;

private:
  std::streambuf* m_buffer;
  int (*m_print)(const char*, ...);
};

// States of a FreeFEM solver: the next factorize does all, or makes new numbers only.
constexpr int NEW = 0, ANALYZED = 2;

/// Its analysis is kept while the pattern stays, but for MUMPS: FreeFEM's takes the numbers of a matrix only with its pattern.
class FreefemSolver final : public SparseSolver {
public:
  FreefemSolver(std::string name, Stack stack) : m_name(std::move(name)), m_stack(stack) {}
  bool symmetric() const override { return takes_triangle(m_name); }
  void analyze(const SparseView& pattern) override;
  bool factorize(const double* value) override;
  void solve(Eigen::MatrixXd& B) override;

private:
  bool is_mumps() const; ///< by whatever name: with it loaded, "SPARSESOLVER" is it, too
  void drop();
  void solve_columns(Eigen::MatrixXd& B, Eigen::MatrixXd& X);

  std::string m_name;
  Stack m_stack;
  std::vector<int> m_place; // of the entries of a pattern in the matrix; empty: the same order
  std::unique_ptr<HashMatrix<int, double>> m_matrix;
  std::unique_ptr<VirtualSolver<int, double>> m_solver;
};

} // namespace

bool takes_triangle(const std::string& name) {
  for (const char* one : {"CHOLMOD", "CHOLESKY", "CROUT", "CG", "SPARSESOLVERSYM"})
    if (name == one) return true;
  return false;
}

std::unique_ptr<SparseSolver> freefem_solver(const std::string& name, Stack stack) {
  if (name == "UMFPACK") return std::make_unique<UmfpackSolver>();
  return std::make_unique<FreefemSolver>(name, stack);
}

bool FreefemSolver::is_mumps() const {
  if (!m_solver) return false;
  const VirtualSolver<int, double>& made = *m_solver;
  return std::string(typeid(made).name()).find("MUMPS") != std::string::npos;
}

// After an error. FreeFEM's MUMPS has ended its instance before it throws; ending it again, as its destructor does, aborts the
// process: what is left of it is not freed.
void FreefemSolver::drop() {
  if (is_mumps()) static_cast<void>(m_solver.release());
  m_solver.reset();
}

void FreefemSolver::analyze(const SparseView& pattern) {
  m_solver.reset();
  m_matrix = sorted_matrix(pattern, m_name, m_place);
}

bool FreefemSolver::factorize(const double* value) {
  HashMatrix<int, double>& A = *m_matrix;
  for (std::size_t k = 0; k < A.nnz; ++k) A.aij[m_place.empty() ? k : m_place[k]] = value[k];
  const QuietLibraries quiet;
  try {
    if (m_solver) {
      m_solver->state = is_mumps() ? NEW : ANALYZED;
    } else {
      Data_Sparse_Solver options;
      options.solver = m_name;
      options.sym = A.half;
      options.verb = 0;
      m_solver.reset(TheFFSolver<int, double>::ffsolver.at(m_name)->create(A, options, m_stack));
      A.re_do_symbolic = 1;
    }
    A.re_do_numerics = 1;
    m_solver->factorize(3);
  } catch (const ::Error&) {
    drop();
    last_error().clear(); // the core says it
    return false;
  }
  return true;
}

// FreeFEM's MUMPS takes the first of several right-hand sides only.
void FreefemSolver::solve_columns(Eigen::MatrixXd& B, Eigen::MatrixXd& X) {
  const int together = is_mumps() ? 1 : static_cast<int>(B.cols());
  for (Eigen::Index c = 0; c < B.cols(); c += together)
    m_solver->dosolver(X.col(c).data(), B.col(c).data(), together, 0);
}

// A failure is left to the residual.
void FreefemSolver::solve(Eigen::MatrixXd& B) {
  const QuietLibraries quiet;
  Eigen::MatrixXd X = Eigen::MatrixXd::Zero(B.rows(), B.cols());
  try {
    if (m_solver && B.cols() > 0)
      solve_columns(B, X);
    else
      X.setConstant(std::nan(""));
  } catch (const ::Error&) {
    drop();
    last_error().clear();
    X.setConstant(std::nan(""));
  }
  B = std::move(X);
}

} // namespace burnish

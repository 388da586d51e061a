#pragma once
// Factor of a sparse symmetric matrix whose owner has ordered it, the candidates of the contact last.
#include "solver/factor_status.hpp"
#include "solver/fill_ordering.hpp"
#include "solver/supernodes.hpp"
#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <vector>

namespace burnish {

/// L L' with L = [L_ii 0; L_ci L_cc], c the last unknowns. Implementations: CholmodFactor; HalvedFactor of two ranks and MumpsFactor
/// of more, which divide L among them and give the same results to all. Not for simultaneous use by several threads.
class OrderedFactor {
public:
  virtual ~OrderedFactor() = default;
  /// Symbolic analysis of the pattern of the lower triangle by columns: rows row[col_start[j] ..
  /// col_start[j+1]), each >= j, in any order; the last entry of col_start is the number of entries.
  /// @param first  the first of c; -1: there is none, neither halves of solve nor trailing_factor will be asked for
  /// @throws std::bad_alloc, std::runtime_error on an error of the library; ArgumentError if the factor is larger than memory_left()
  virtual void analyze(std::vector<int> col_start, std::vector<int> row, int first = -1) = 0;
  /// Numerical factor of the matrix with these values, in the order of `row` of analyze(); they are not kept. After
  /// NOT_POSITIVE_DEFINITE there is no factor to use.
  /// @throws std::logic_error before analyze() or for another number of values; std::bad_alloc, std::runtime_error on an error
  /// of the library
  virtual FactorStatus factorize(std::vector<double> values) = 0;
  virtual bool is_factorized() const = 0;
  /// Replaces every column of b (n x any number) by A^-1 b.
  /// @throws std::logic_error if there is no factor or b has not n rows
  virtual void solve(Eigen::Ref<Eigen::MatrixXd> b) const = 0;
  /// The halves of solve, for one column. After the first, b_c is L_cc^-1 (b_c - L_ci L_ii^-1 b_i), to which more may be added;
  /// what b_i is, is the implementation's.
  virtual void solve_lower(Eigen::Ref<Eigen::MatrixXd> b) const = 0;
  virtual void solve_upper(Eigen::Ref<Eigen::MatrixXd> b) const = 0;
  /// L_cc, lower triangular, over the unknowns from `first` on. @throws std::logic_error if there is no factor or first is another than
  /// analyze was told
  virtual Eigen::MatrixXd trailing_factor(int first) const = 0;
  /// L itself where this process has it; none otherwise. @throws std::logic_error if there is no factor
  virtual std::optional<Supernodes> supernodes() const { return {}; }
  virtual int size() const = 0;
  /// Numbers stored in L; 0 before analyze().
  virtual std::size_t factor_entries() const = 0;
};

/// An order for the factor that make_ordered_factor gives.
/// @param graph    of what is eliminated first: all but c
/// @param unknowns of the matrix
/// @param dim      of the body
/// @throws as fill_reducing_order
EliminationOrder elimination_order(const Graph& graph, Ordering ordering, int unknowns, int dim);

/// By CHOLMOD; of a divided body by CHOLMOD on two ranks, by MUMPS on more.
/// @param unknowns, dim  as above
/// @param halves         unknowns of the halves that elimination_order found
std::unique_ptr<OrderedFactor> make_ordered_factor(int unknowns, int dim, const std::array<int, 2>& halves);

} // namespace burnish

#pragma once
// Columns of L^-1: their products are the flexibility, without a second half of a solve (ALGORITHMS.md 8.7).
#include "solver/supernodes.hpp"
#include <Eigen/Dense>
#include <vector>

namespace burnish {

/// e_i' K^-1 e_j = (L^-1 e_i)' (L^-1 e_j) with K = L L'. A column of L^-1 is zero but on the way from its supernode to the root of the
/// elimination tree, and only that way is computed and kept.
class HalfColumns {
public:
  /// @param L     must stay valid
  /// @param place row of K -> row of L, must stay valid
  HalfColumns(const Supernodes& L, const std::vector<int>& place);
  /// Computes L^-1 e of further rows of K, which get the next numbers, and their products.
  /// @param rows  of K, each once
  /// @param gram  square, as many rows as columns are known then, at least; those of the new numbers are zero and get their products
  void append(const std::vector<int>& rows, Eigen::MatrixXd& gram);
  /// sum of weight_j L^-1 e_j over the known columns, in the order of L.
  Eigen::VectorXd sum(const Eigen::VectorXd& weight) const;
  int known() const { return m_known; }

private:
  struct Panel {                // of one supernode
    std::vector<int> columns;   // numbers of those whose way it is on
    std::vector<double> values; // [rows of the supernode's own x columns]
  };
  void append_some(const int* first, const int* last, const std::vector<int>& rows, Eigen::MatrixXd& gram);
  void pass(int s, Eigen::MatrixXd& gram);

  const Supernodes m_L;
  const std::vector<int>& m_place;
  std::vector<int> m_supernode; // per column of L
  std::vector<Panel> m_panels;  // per supernode
  std::vector<std::vector<int>>
      m_passing;              // per supernode: the columns under way that come through, places in m_numbers
  std::vector<int> m_numbers; // of the columns under way
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>
      m_rest; // their right-hand sides, all rows; zero between calls
  int m_known = 0;
};

} // namespace burnish

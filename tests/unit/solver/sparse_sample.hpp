#pragma once
// Compressed-row matrices for the tests of the general solvers.
#include "solver/sparse_view.hpp"
#include "unit/solver/elastic_sample.hpp"
#include <functional>

namespace burnish::sample {

struct Sparse {
  std::vector<int> row_start{0}, col;
  std::vector<double> value;
  bool symmetric = false;
  int n() const { return static_cast<int>(row_start.size()) - 1; }
  SparseView view() const { return {n(), row_start.data(), col.data(), value.data(), symmetric}; }
};

/// Entries (i, j) with keep(i, j) of a dense matrix, zeros left out.
inline Sparse sparse(const Eigen::MatrixXd& full, const std::function<bool(int, int)>& keep,
                     bool symmetric = false) {
  Sparse result;
  result.symmetric = symmetric;
  for (int i = 0; i < full.rows(); ++i) {
    for (int j = 0; j < full.cols(); ++j) {
      if (!keep(i, j) || full(i, j) == 0.) continue;
      result.col.push_back(j);
      result.value.push_back(full(i, j));
    }
    result.row_start.push_back(static_cast<int>(result.col.size()));
  }
  return result;
}

inline Sparse sparse(const Eigen::MatrixXd& full) {
  return sparse(full, [](int, int) { return true; });
}

/// The values of a dense matrix at the places where another one is not zero.
inline Sparse stored_like(const Eigen::MatrixXd& full, const Eigen::MatrixXd& pattern) {
  Sparse result = sparse(pattern);
  for (int i = 0; i < result.n(); ++i)
    for (int k = result.row_start[i]; k < result.row_start[i + 1]; ++k)
      result.value[k] = full(i, result.col[k]);
  return result;
}

/// Elastic ring sector, exactly symmetric.
inline Eigen::MatrixXd symmetric_matrix(int num_radial = 3, int num_along = 6) {
  const Eigen::MatrixXd full = dense(stiffness(with_mid_nodes(ring_sector(num_radial, num_along)), 0.1));
  return (full + full.transpose()) / 2;
}

/// The same with friction-like rows: row i gets a part of the row of its node's other dof.
inline Eigen::MatrixXd with_friction_rows(Eigen::MatrixXd full, const std::vector<int>& rows,
                                          double mu = 0.3) {
  const Eigen::MatrixXd original = full;
  for (int i : rows) full.row(i) += mu * original.row(i % 2 == 0 ? i + 1 : i - 1);
  return full;
}

} // namespace burnish::sample

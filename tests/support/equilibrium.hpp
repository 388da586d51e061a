#pragma once
// A workpiece without tools in equilibrium: some degrees of freedom given, nodal forces on the others.
#include "workpiece/workpiece.hpp"
#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

namespace burnish::test {

/// Change of the displacement, -K_ff^-1 residual_f at the degrees of freedom that are not held, else 0.
template <int Dim>
Eigen::VectorXd correction(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& residual,
                           const std::vector<char>& held) {
  std::vector<int> number(held.size(), -1);
  int free = 0;
  for (std::size_t k = 0; k < held.size(); ++k)
    if (!held[k]) number[k] = free++;
  std::vector<Eigen::Triplet<double>> entries;
  for (int a = 0; a < K.num_nodes; ++a)
    for (int slot = K.row_start[a]; slot < K.row_start[a + 1]; ++slot)
      for (int c = 0; c < Dim * Dim; ++c) {
        const int i = number[Dim * a + c / Dim], j = number[Dim * K.col[slot] + c % Dim];
        if (i >= 0 && j >= 0) entries.emplace_back(i, j, K.block(slot)[c]);
      }
  Eigen::SparseMatrix<double> matrix(free, free);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  Eigen::VectorXd right(free), shift = Eigen::VectorXd::Zero(residual.size());
  for (std::size_t k = 0; k < held.size(); ++k)
    if (!held[k]) right[number[k]] = -residual[k];
  const Eigen::VectorXd solution = solver.solve(right);
  for (std::size_t k = 0; k < held.size(); ++k)
    if (!held[k]) shift[k] = solution[number[k]];
  return shift;
}

/// One step to equilibrium without outer forces by Newton's method.
/// @param u start of the iteration, with the given values in place; equilibrium on return
template <int Dim>
void equilibrate(Workpiece<Dim>& body, const std::vector<char>& held, Eigen::VectorXd& u, double dt = 1) {
  NodeBlockMatrix<Dim> K = body.pattern();
  double before = 0;
  for (int it = 0; it < 40; ++it) {
    ASSERT_EQ(body.update(u, dt, it).status, UpdateStatus::OK) << "iteration " << it;
    Eigen::VectorXd residual = body.internal_force();
    const double largest = residual.cwiseAbs().maxCoeff();
    for (std::size_t k = 0; k < held.size(); ++k)
      if (held[k]) residual[k] = 0;
    const double size = residual.cwiseAbs().maxCoeff();
    if (size <= 1e-12 * largest || (it > 0 && size <= 1e-9 * largest && size > 0.5 * before)) return;
    before = size;
    body.tangent(K, TangentKind::CONSISTENT);
    u += correction(K, residual, held);
  }
  FAIL() << "no equilibrium after 40 iterations";
}

} // namespace burnish::test

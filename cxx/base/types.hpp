#pragma once
// Fixed-size vectors and tensors of the core, templated on the space dimension.
#include <Eigen/Dense>

namespace burnish {

template <int Dim> using Vector = Eigen::Matrix<double, Dim, 1>;
template <int Dim> using Tensor = Eigen::Matrix<double, Dim, Dim>;
/// Surface parameters of a tool: one in the plane, two in space.
template <int Dim> using Param = Eigen::Matrix<double, Dim - 1, 1>;
/// Columns are tangent vectors, one per surface parameter.
template <int Dim> using Tangents = Eigen::Matrix<double, Dim, Dim - 1>;
/// Normal curvatures of a surface in a pair of tangents.
template <int Dim> using Curvature = Eigen::Matrix<double, Dim - 1, Dim - 1>;
/// Columns belong to the generalized coordinates of one tool (any number of them).
template <int Dim> using PerCoordinate = Eigen::Matrix<double, Dim, Eigen::Dynamic>;

} // namespace burnish

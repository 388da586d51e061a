#pragma once
// How many components the tensors of a point have, and which: here the plane and space differ by numbers.
#include "base/types.hpp"
#include <array>

namespace burnish {

/// Components kept at a quadrature point. Shear entries of symmetric tensors are tensor components (not doubled).
template <int Dim> struct PointTraits;

/// Plane strain or axisymmetry (x = r, y along the axis, zz = hoop): the plane and one direction out of it.
template <> struct PointTraits<2> {
  static constexpr int num_stress = 4; ///< xx, yy, zz, xy
  static constexpr int num_gradient =
      5; ///< xx, xy, yx, yy, zz; F_zz is 1 in plane strain, 1 + u_r/R in axisymmetry
  static constexpr int num_rotations = 1; ///< counter-clockwise
  static constexpr bool has_hoop =
      true; ///< the gradient has a component out of the mesh's plane, the last one
  static constexpr std::array<const char*, 4> stress_names{"xx", "yy", "zz", "xy"};
  static constexpr std::array<const char*, 2> axis_names{"x", "y"};
  /// Row and column of each component that lies in the mesh's space; {-1, -1}: out of it.
  static constexpr std::array<std::array<int, 2>, 4> place{{{0, 0}, {1, 1}, {-1, -1}, {0, 1}}};
};

/// Space.
template <> struct PointTraits<3> {
  static constexpr int num_stress = 6;    ///< xx, yy, zz, xy, yz, zx
  static constexpr int num_gradient = 9;  ///< row-major
  static constexpr int num_rotations = 3; ///< about x, y, z
  static constexpr bool has_hoop = false;
  static constexpr std::array<const char*, 6> stress_names{"xx", "yy", "zz", "xy", "yz", "zx"};
  static constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};
  static constexpr std::array<std::array<int, 2>, 6> place{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
};

template <int Dim> inline constexpr int num_stress = PointTraits<Dim>::num_stress;
template <int Dim> inline constexpr int num_gradient = PointTraits<Dim>::num_gradient;
/// A step's increments: the strains of Stress<Dim>, then the rotations.
template <int Dim> inline constexpr int num_increments = num_stress<Dim> + PointTraits<Dim>::num_rotations;

/// Stress or strain of a point.
template <int Dim> using Stress = Eigen::Matrix<double, num_stress<Dim>, 1>;
/// Gradient of a point.
template <int Dim> using Gradient = Eigen::Matrix<double, num_gradient<Dim>, 1>;
inline constexpr int ZZ = 4; ///< place of the hoop component where PointTraits<Dim>::has_hoop

} // namespace burnish

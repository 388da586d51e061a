#pragma once
// The increments of a step at a point, from which a stress update starts.
#include "material/point_traits.hpp"

namespace burnish {

/// dy/dF, columns in the order of Gradient.
template <int Dim> using IncrementByF = Eigen::Matrix<double, num_increments<Dim>, num_gradient<Dim>>;

/// A step's increments y: strains in the order of Stress, then the rotation of the law's corotational rate, both in the
/// law's frame (METHOD.md 1.6), and dy/dF, columns in the order of Gradient. In space the rotation is its rotation vector,
/// and its rows of by_F are the spins about x, y, z by which it changes, METHOD.md (1.37).
template <int Dim> struct StepIncrements {
  Eigen::Matrix<double, num_increments<Dim>, 1> y;
  IncrementByF<Dim> by_F;
};

} // namespace burnish

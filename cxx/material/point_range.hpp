#pragma once
// The step of quadrature points that stand one after another in point-major arrays.
#include "material/point_step.hpp"

namespace burnish {

/// Steps of `size` points: every pointer is to the first one's numbers, those of the others follow.
template <int Dim> struct RangeStep {
  int size = 0;
  const double* F_old = nullptr;                ///< size x num_gradient: PointState::F at the start [-]
  const double* stress_old = nullptr;           ///< size x num_stress [stress]
  const double* internal_old = nullptr;         ///< size x num_internal
  const double* strain_increment_old = nullptr; ///< size x num_stress [-]
  const char* plastic_old = nullptr;            ///< size
  int num_internal = 0;                         ///< InternalVariables::size()
  const double* F = nullptr;                    ///< size x num_gradient: at the end, determinant > 0 [-]
  double ratio = 0;                             ///< ra = dt/dt_old; 0: no last step
  int iteration = 0;                            ///< 0, 1, 2.. within the step
  const UpdateOptions& options;                 ///< valid

  PointStep<Dim> point(int k) const {
    const std::size_t p = k;
    return {{Eigen::Map<const Gradient<Dim>>(F_old + p * num_gradient<Dim>),
             Eigen::Map<const Stress<Dim>>(stress_old + p * num_stress<Dim>), internal_old + p * num_internal,
             Eigen::Map<const Stress<Dim>>(strain_increment_old + p * num_stress<Dim>), plastic_old[p] != 0},
            Eigen::Map<const Gradient<Dim>>(F + p * num_gradient<Dim>),
            ratio,
            iteration,
            options};
  }
};

/// Where what is found for the end of the step goes, in the same order.
template <int Dim> struct RangeUpdate {
  double* stress = nullptr;           ///< size x num_stress [stress]
  double* internal = nullptr;         ///< size x num_internal
  double* strain_increment = nullptr; ///< size x num_stress [-]
  char* plastic = nullptr;            ///< size
  PointTrial* trial = nullptr;        ///< size: of the same step's last iteration in, of this one out
};

struct RangeResult {
  PointResult result; ///< of the first point that failed
  int point = -1;     ///< its place in the range; -1: none failed
};

} // namespace burnish

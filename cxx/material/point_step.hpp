#pragma once
// The step of one quadrature point as a law sees it: where it starts, where it leads, what becomes of it.
#include "material/gradient.hpp"
#include "material/update_options.hpp"
#include <cmath>

namespace burnish {

/// A point at the start or at the end of a step: a view of arrays that somebody else owns.
template <int Dim> struct PointState {
  Eigen::Map<const Gradient<Dim>> F;              ///< deformation gradient [-]
  Eigen::Map<const Stress<Dim>> stress;           ///< Kirchhoff stress tau [stress]
  const double* internal = nullptr;               ///< internal variables, InternalVariables::size() numbers
  Eigen::Map<const Stress<Dim>> strain_increment; ///< dd of the step that ended here, in its frame [-]
  bool plastic = false; ///< inelastic flow happened in that step, or an event put the point on the surface
};

/// A step of a point: from `old` to the deformation gradient F.
template <int Dim> struct PointStep {
  PointState<Dim> old;          ///< at the start
  Gradient<Dim> F;              ///< at the end, determinant(F) > 0 [-]
  double ratio = 0;             ///< ra = dt/dt_old; 0: no last step
  int iteration = 0;            ///< 0, 1, 2.. within the step
  const UpdateOptions& options; ///< valid
};

/// What the law finds for the end of the step.
template <int Dim> struct PointUpdate {
  Stress<Dim> stress;           ///< Kirchhoff stress [stress]
  double* internal = nullptr;   ///< in: where to write the internal variables, all of them
  Stress<Dim> strain_increment; ///< dd [-]
  bool plastic = false;         ///< inelastic flow happened in the step
};

/// What a point hands from one iteration of a step to the next; zero at iteration 0. No part of the state.
struct PointTrial {
  int substeps = 0; ///< the largest number so far, 0: elastic so far
  int used = 0;     ///< by the last update, 0: elastic
};

enum class UpdateStatus {
  OK,
  INVERTED_ELEMENT,
  NOT_FINITE,
  NO_RETURN, ///< the yield stress has no value > 0 there, or falls faster than the elastic stress, METHOD.md 1.7
};
struct PointResult {
  UpdateStatus status = UpdateStatus::OK;
  double value =
      0; ///< the determinant that is not > 0, or not finite; NO_RETURN: ep at the start of the step
};
/// OK if det is finite and > 0.
inline PointResult determinant_result(double det) {
  if (det > 0 && std::isfinite(det)) return {};
  return {std::isfinite(det) ? UpdateStatus::INVERTED_ELEMENT : UpdateStatus::NOT_FINITE, det};
}

} // namespace burnish

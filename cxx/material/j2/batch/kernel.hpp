#pragma once
// Update of J2 several points at a time, by the instructions that this machine has. Every point goes through the operations of
// J2Law::update in their order, without fused ones, so it ends at the same bits.
#include "material/j2/parameters.hpp"
#include "material/point_range.hpp"

namespace burnish {

/// A kernel, or none.
struct J2Kernel {
  int width = 1; ///< points at a time
  /// Updates points of a range from `first` on, `width` at a time, and stops before those `width` among which one fails, or where
  /// fewer are left: J2Law::update says then which point it is, and what its status.
  /// @param material and options covered @return first point that is not updated
  int (*update)(const J2Parameters& material, const RangeStep<2>& step, int first,
                const RangeUpdate<2>& now) = nullptr;
};

/// What kernels cover: sub-stepped returns with the Jaumann rate, any isotropic hardening, no back stress.
bool covered(const J2Parameters& material, const UpdateOptions& options);

/// For this machine: AVX2, or none.
J2Kernel j2_kernel();

} // namespace burnish

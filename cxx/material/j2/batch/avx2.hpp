#pragma once
// The kernel of j2/batch/kernel.hpp for machines with AVX2.
#include "material/j2/batch/kernel.hpp"

namespace burnish {
#if defined(__x86_64__)

inline constexpr int J2_AVX2_WIDTH = 4;
/// See J2Kernel::update. To be called only where the machine has AVX2.
int j2_update_avx2(const J2Parameters& material, const RangeStep<2>& step, int first,
                   const RangeUpdate<2>& now);

#endif
} // namespace burnish

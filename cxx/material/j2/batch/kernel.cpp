#include "material/j2/batch/kernel.hpp"
#include "material/j2/batch/avx2.hpp"

namespace burnish {

bool covered(const J2Parameters& material, const UpdateOptions& options) {
  return options.update == StressUpdate::SUBSTEPPED && material.rate == CorotationalRate::JAUMANN &&
         !material.kinematic.exists();
}

J2Kernel j2_kernel() {
#if defined(__x86_64__)
  static const bool avx2 = __builtin_cpu_supports("avx2");
  if (avx2) return {J2_AVX2_WIDTH, j2_update_avx2};
#endif
  return {};
}

} // namespace burnish

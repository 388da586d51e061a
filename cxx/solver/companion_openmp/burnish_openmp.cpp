// The library burnish_openmp.so, which burnish loads before OpenMP's run time (LD_PRELOAD): parallel regions that an OpenmpGuard wants on
// one thread are plain calls. With a team of one thread each of them costs a call of the system: a third of a factorization in the plane
// where such calls are dear.
#include "solver/openmp_guard.hpp"
#include <dlfcn.h>

namespace {

thread_local bool serial = false;

} // namespace

extern "C" bool burnish_serial_regions(bool wanted) {
  const bool before = serial;
  serial = wanted;
  return before;
}

extern "C" void GOMP_parallel(void (*region)(void*), void* data, unsigned threads, unsigned flags) {
  if (serial) return region(data);
  static void* const loaded_before =
      dlsym(RTLD_NEXT, "GOMP_parallel"); // of OpenMP's run time: null if this library was opened later
  static void* const opened_later = loaded_before ? loaded_before : dlsym(RTLD_DEFAULT, "GOMP_parallel");
  reinterpret_cast<decltype(&GOMP_parallel)>(opened_later)(region, data, threads, flags);
}

#include "solver/openmp_guard.hpp"
#include <dlfcn.h>

namespace burnish {

namespace {

constexpr int OPENBLAS_OPENMP = 2; // openblas_get_parallel: 0 sequential, 1 threads, 2 OpenMP

struct OpenmpRuntime {
  using Get = int();
  using Set = void(int);
  Get* get_levels = reinterpret_cast<Get*>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
  Set* set_levels = reinterpret_cast<Set*>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
  decltype(&burnish_serial_regions) set_serial =
      reinterpret_cast<decltype(&burnish_serial_regions)>(dlsym(RTLD_DEFAULT, "burnish_serial_regions"));
  bool is_usable() const {
    auto* parallel = reinterpret_cast<Get*>(dlsym(RTLD_DEFAULT, "openblas_get_parallel"));
    return get_levels && set_levels && !(parallel && parallel() == OPENBLAS_OPENMP);
  }
};

} // namespace

OpenmpGuard::OpenmpGuard() {
  const OpenmpRuntime runtime;
  if (!runtime.is_usable()) return;
  if (runtime.set_serial) m_serial = runtime.set_serial(true);
  m_levels = runtime.get_levels();
  runtime.set_levels(0);
}

OpenmpGuard::~OpenmpGuard() {
  if (m_levels < 0) return;
  const OpenmpRuntime runtime;
  if (runtime.set_serial) runtime.set_serial(m_serial);
  runtime.set_levels(m_levels);
}

} // namespace burnish

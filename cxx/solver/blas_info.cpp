#include "solver/blas_info.hpp"
#include "base/error.hpp"
#include <cstdlib>
#include <dlfcn.h>
#include <sstream>
#include <suitesparse/cholmod.h>
#include <suitesparse/umfpack.h>

namespace burnish {

namespace {

/// Function of the process or of the libraries loaded with this one, null if there is none of that name.
template <class Function> Function* find_function(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

} // namespace

std::string sparse_solver_versions() {
  std::ostringstream text;
  text << "CHOLMOD " << CHOLMOD_MAIN_VERSION << "." << CHOLMOD_SUB_VERSION << "." << CHOLMOD_SUBSUB_VERSION
       << ", UMFPACK " << UMFPACK_MAIN_VERSION << "." << UMFPACK_SUB_VERSION << "." << UMFPACK_SUBSUB_VERSION;
  return text.str();
}

std::string blas_name() {
  auto* get_config = find_function<char*()>("openblas_get_config");
  const char* config = get_config ? get_config() : nullptr;
  return config ? config : "reference or unknown BLAS";
}

bool is_reference_blas() { return find_function<char*()>("openblas_get_config") == nullptr; }

std::string better_blas_kernels(const std::string& taken) {
#ifdef __x86_64__
  if (taken != "Prescott") return "";
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "Haswell";
#endif
  return "";
}

std::string take_blas_kernels() {
  const char* choice = "OPENBLAS_CORETYPE";
  auto* name = find_function<char*()>("openblas_get_corename");
  auto* quit = find_function<void()>("gotoblas_dynamic_quit");
  auto* init = find_function<void()>("gotoblas_dynamic_init");
  if (!name || !quit || !init || std::getenv(choice)) return "";
  const std::string better = better_blas_kernels(name());
  if (better.empty()) return "";
  setenv(choice, better.c_str(), 1);
  quit();
  init();
  unsetenv(choice);
  return better;
}

bool set_blas_threads(int count) {
  require(count >= 1, "set_blas_threads", "count", count, "count >= 1");
  auto* set_num_threads = find_function<void(int)>("openblas_set_num_threads");
  if (!set_num_threads) return false;
  set_num_threads(count);
  return true;
}

} // namespace burnish

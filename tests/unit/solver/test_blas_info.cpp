#include "solver/blas_info.hpp"
#include <cstdlib>
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <stdexcept>

using namespace burnish;

TEST(BlasInfo, NameAndKindAgreeWithTheProcess) {
  const bool has_openblas = dlsym(RTLD_DEFAULT, "openblas_get_config") != nullptr;
  EXPECT_EQ(is_reference_blas(), !has_openblas);
  EXPECT_EQ(blas_name().find("OpenBLAS") == 0, has_openblas) << blas_name();
  EXPECT_EQ(blas_name() == "reference or unknown BLAS", !has_openblas) << blas_name();
}

TEST(BlasInfo, SetsThreadsWhereItCan) {
  auto* get_threads = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
  EXPECT_EQ(set_blas_threads(1), get_threads != nullptr);
  EXPECT_EQ(get_threads ? get_threads() : 1, 1); // without OpenBLAS the line above is the test
}

TEST(BlasInfo, RefusesLessThanOneThread) { EXPECT_THROW(set_blas_threads(0), std::invalid_argument); }

// A processor that OpenBLAS does not know gets kernels without AVX: those of a known one with the same instructions are taken.
TEST(BlasInfo, KernelsOfAnUnknownProcessor) {
  auto* name = reinterpret_cast<char* (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  auto* quit = reinterpret_cast<void (*)()>(dlsym(RTLD_DEFAULT, "gotoblas_dynamic_quit"));
  auto* init = reinterpret_cast<void (*)()>(dlsym(RTLD_DEFAULT, "gotoblas_dynamic_init"));
  EXPECT_EQ(better_blas_kernels("Zen"), "");
  EXPECT_EQ(better_blas_kernels("SkylakeX"), "");
  const std::string better = better_blas_kernels("Prescott");
  if (better.empty() || !name || !quit || !init) return; // no AVX2, or no OpenBLAS of many kernels
  const char* chosen = std::getenv("OPENBLAS_CORETYPE");
  const std::string before = chosen ? chosen : "";
  const auto restart = [&](const char* kernels) {
    kernels ? setenv("OPENBLAS_CORETYPE", kernels, 1) : unsetenv("OPENBLAS_CORETYPE");
    quit();
    init();
  };
  restart("Prescott");
  EXPECT_EQ(take_blas_kernels(), ""); // the user's choice
  EXPECT_STREQ(name(), "Prescott");
  unsetenv("OPENBLAS_CORETYPE"); // as of a processor that is not known
  EXPECT_EQ(take_blas_kernels(), better);
  EXPECT_EQ(name(), better);
  EXPECT_EQ(std::getenv("OPENBLAS_CORETYPE"), nullptr);
  restart(chosen ? before.c_str() : nullptr);
}

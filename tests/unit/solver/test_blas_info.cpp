#include "solver/blas_info.hpp"
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

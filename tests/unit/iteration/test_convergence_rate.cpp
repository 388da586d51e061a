// Whether an iteration with a kept factor lags.
#include "iteration/convergence_rate.hpp"
#include <gtest/gtest.h>

using burnish::ConvergenceRate;

TEST(ConvergenceRate, LagsWhereTooManyIterationsAreLeft) {
  for (const double unit : {1e-9, 1., 1e9}) {
    ConvergenceRate rate(4, 8);
    double residual = unit;
    for (int k = 0; k < 4; ++k, residual *= 0.5)
      EXPECT_FALSE(rate.slow(residual, 1e-12 * unit)) << "not known yet";
    EXPECT_TRUE(rate.slow(residual, residual / 300)) << "8.2 iterations are left";
    EXPECT_FALSE(rate.slow(0.5 * residual, residual / 500)) << "8 halvings are 256";
    EXPECT_DOUBLE_EQ(rate.fall(), 0.5 * residual / unit);
    rate.clear();
    EXPECT_FALSE(rate.slow(residual, 1e-12 * unit));
  }
}

TEST(ConvergenceRate, GrowingResidualsLag) {
  ConvergenceRate rate(2, 8), never(0, 8);
  for (int k = 0; k < 2; ++k) rate.slow(1, 1e-4);
  EXPECT_TRUE(rate.slow(1, 1e-4));
  EXPECT_FALSE(rate.slow(1e-5, 1e-4)) << "converged";
  for (int k = 0; k < 20; ++k) EXPECT_FALSE(never.slow(1, 1e-4));
}

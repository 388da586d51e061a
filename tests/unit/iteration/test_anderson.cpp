// Anderson mixing: a linear fixed point is found in as many steps as it has unknowns.
#include "iteration/anderson.hpp"
#include <gtest/gtest.h>
#include <random>

using namespace burnish;

namespace {

/// A z = f solved by z += g with the wrong matrix K g = f - A z; K symmetric positive definite.
struct LinearProblem {
  Eigen::MatrixXd A, K;
  Eigen::VectorXd f;
  explicit LinearProblem(int n) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto any = [&] { return uniform(random); };
    const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(n, n, any),
                          C = Eigen::MatrixXd::NullaryExpr(n, n, any);
    A = B * B.transpose() + 0.5 * Eigen::MatrixXd::Identity(n, n);
    K = A + 0.3 * C * C.transpose();
    f = Eigen::VectorXd::NullaryExpr(n, any);
  }
  /// Residuals of `steps` iterations from zero.
  std::vector<double> residuals(AndersonMixer& mixer, int steps) const {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(f.size());
    std::vector<double> history;
    for (int k = 0; k < steps; ++k) {
      const Eigen::VectorXd b = f - A * z;
      history.push_back(b.norm());
      z += mixer.mix(z, K.ldlt().solve(b), b);
    }
    return history;
  }
};

} // namespace

TEST(Anderson, LinearProblemInAsManyStepsAsUnknowns) {
  const LinearProblem problem(5);
  AndersonMixer mixer(8), off(0);
  const auto mixed = problem.residuals(mixer, 8), plain = problem.residuals(off, 8);
  EXPECT_TRUE(mixer.mixed());
  EXPECT_FALSE(off.mixed());
  EXPECT_LE(mixed[6], 1e-9 * mixed[0]);
  EXPECT_GE(plain[6], 1e-4 * plain[0]) << "without mixing the test would show nothing";
  EXPECT_EQ(mixed[1], plain[1]) << "the first step has no history";
}

TEST(Anderson, ShortMemoryStillHelps) {
  const LinearProblem problem(5);
  AndersonMixer two(2), off(0);
  const auto mixed = problem.residuals(two, 12), plain = problem.residuals(off, 12);
  EXPECT_LE(mixed[11], 0.1 * plain[11]);
}

TEST(Anderson, ClearForgets) {
  const LinearProblem problem(4);
  AndersonMixer mixer(8);
  problem.residuals(mixer, 3);
  mixer.clear();
  const Eigen::VectorXd g = Eigen::VectorXd::Ones(4);
  EXPECT_EQ(mixer.mix(problem.f, g, problem.K * g), g);
  EXPECT_FALSE(mixer.mixed());
}

// Nearly parallel corrections would be extrapolated a hundredfold: the plain correction is kept.
TEST(Anderson, LargeCoefficientsAreRefused) {
  AndersonMixer mixer(8);
  const Eigen::Vector2d g0(1, 0), g1(0.99, 0);
  mixer.mix(Eigen::Vector2d::Zero(), g0, g0);
  EXPECT_EQ(mixer.mix(g0, g1, g1), Eigen::VectorXd(g1));
  EXPECT_FALSE(mixer.mixed());
}

// z may be longer than b (coordinates of tools): they take part in the mix, not in the product.
TEST(Anderson, ProductRunsOverTheRightHandSide) {
  AndersonMixer mixer(8);
  mixer.mix(Eigen::Vector3d(0, 0, 7), Eigen::Vector3d(1, 0, 1), Eigen::Vector2d(1, 0));
  const Eigen::VectorXd step =
      mixer.mix(Eigen::Vector3d(1, 0, 8), Eigen::Vector3d(0.5, 0, 0.25), Eigen::Vector2d(0.5, 0));
  // c = -1: the correction has halved, so two of it are left; the last entry follows with the same c
  EXPECT_TRUE(mixer.mixed());
  EXPECT_NEAR(step[0], 1, 1e-10);
  EXPECT_NEAR(step[2], 0.25 + (1 - 0.75), 1e-10);
}

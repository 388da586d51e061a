#include "geometry/plane.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

TEST(Plane, QuarterTurns) {
  expect_close(plane_direction(M_PI_2), Vector<2>(0, 1), 1, 1e-15, "e(pi/2)");
  expect_close(left_of({3, 4}), Vector<2>(-4, 3), 1, 0, "left of (3,4)");
  expect_close(plane_rotation(M_PI_2) * Vector<2>(2, 0), Vector<2>(0, 2), 1, 1e-15, "R(pi/2) (2,0)");
}

TEST(Plane, RotationAndItsDerivative) {
  for (double angle : {-4.0, -0.3, 0.0, 1.1, 7.0}) {
    const Tensor<2> R = plane_rotation(angle);
    expect_close(R * R.transpose(), Tensor<2>::Identity(), 1, 1e-15, "R R'");
    EXPECT_NEAR(R.determinant(), 1, 1e-15);
    expect_close(plane_rotation_derivative(R), finite_difference(plane_rotation, angle, 1e-3), 1, 1e-11,
                 "R'");
    expect_close(plane_rotation_derivative(plane_rotation_derivative(R)), -R, 1, 0, "R''");
  }
}

// What a direction of slip that is off the slip itself counts for, METHOD.md (3.14f).
#include "contact/slip_direction.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double C = 0.05, OWN = 1; // c of METHOD.md (3.14), of what it is a part
const TangentialLaw<3> LAW(make_coulomb(0.25));
const DecidingForce<3> PRESSED{{8, Param<3>(-2, 0)}, 1}; // g = 2
Param<3> at_angle(double size, double angle) { return size * Param<3>(std::cos(angle), std::sin(angle)); }

double off(double slip, double angle, const DecidingForce<3>& deciding = PRESSED) {
  return direction_residual(LAW, deciding, Param<3>(1, 0), at_angle(slip, angle), C);
}

} // namespace

TEST(SlipDirection, OffTheSlipIsAForceOfTheAngle) {
  for (const double angle : {-1.2, -0.1, 0.01, 0.7, 1.5}) {
    const double chord = 2 * std::abs(std::sin(angle / 2));
    EXPECT_NEAR(off(1e9, angle), 2 * chord, 1e-8) << "of a long slip the change of the friction force";
    EXPECT_NEAR(off(1e-9, angle), OWN * 1e-9 * chord, 1e-17) << "of a short one what would turn the slip";
    EXPECT_NEAR(off(2, angle), chord, 1e-14) << "the harmonic mean";
  }
}

TEST(SlipDirection, NothingIsOffWhereNothingTurns) {
  EXPECT_EQ(off(1, 0), 0);
  EXPECT_EQ(off(0, 0), 0) << "no slip";
  EXPECT_EQ(off(1, 2), 0) << "slipped back: it is to stick";
  DecidingForce<3> unpressed = PRESSED, lifted = PRESSED;
  unpressed.unpressed = true;
  lifted.force.N = -1;
  EXPECT_EQ(off(1, 1, unpressed), 0);
  EXPECT_EQ(off(1, 1, lifted), 0);
  EXPECT_EQ(direction_residual(LAW, PRESSED, Param<3>(1, 0), at_angle(1, 1), 0), 0) << "c = 0: nothing turns";
  const TangentialLaw<2> plane(make_coulomb(0.25));
  const DecidingForce<2> pressed{{8, Param<2>(-2)}, 1};
  EXPECT_EQ(direction_residual(plane, pressed, Param<2>(1), Param<2>(0.5), C), 0);
}

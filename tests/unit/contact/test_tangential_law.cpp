// What happens along the surface in the plane and in space: the cone, stick, slip, release; forces at N <= 0.
#include "contact/formula_friction.hpp"
#include "contact/tangential_law.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>
#include <limits>

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double INF = std::numeric_limits<double>::infinity(), AREA = 2;
const ContactTolerance TOLERANCE{1e-3, 1e-4};

template <class Dimension> struct TangentialLaws : testing::Test {
  static constexpr int Dim = Dimension::value;
  using Law = TangentialLaw<Dim>;
  using Along = Param<Dim>;

  /// Some direction, unit.
  static Along direction() {
    Along m = Along::Constant(0.6);
    if constexpr (Dim == 3) m[1] = -0.8;
    return m.normalized();
  }
  static SurfaceForce<Dim> force(double N, double T) { return {N, T * direction()}; }
  static Change test(const Law& law, NodeState state, const SurfaceForce<Dim>& force, double slip = 0) {
    const Along m = law.frictionless() ? Along(Along::Zero()) : direction();
    return law.test(state, force.N, {force, AREA}, slip * direction(), m, TOLERANCE);
  }
  static Law coulomb() { return Law(make_coulomb(0.25)); }
  static Law tresca() { return Law(make_tresca(3)); }
  static Law formula() { return Law(make_formula_friction("mu*p/(1 + p/p0)", {{"mu", 0.5}, {"p0", 40}})); }
};
using Both = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(TangentialLaws, Both);

constexpr NodeState HELD[] = {NodeState::STICKING, NodeState::TOUCHED};

} // namespace

// mu N = 2 at N = 8.
TYPED_TEST(TangentialLaws, InsideAndOutsideTheCone) {
  using T = TestFixture;
  const auto law = T::coulomb();
  for (const NodeState state : HELD)
    for (const double sense : {1., -1.}) {
      EXPECT_EQ(T::test(law, state, T::force(8, 0)), Change::NONE);
      EXPECT_EQ(T::test(law, state, T::force(8, 1.999 * sense)), Change::NONE);
      EXPECT_EQ(T::test(law, state, T::force(8, 2.0009 * sense)), Change::NONE) << "within the tolerance";
      EXPECT_EQ(T::test(law, state, T::force(8, 2.0011 * sense)), Change::SLIDE);
      EXPECT_EQ(T::test(law, state, T::force(8, 50 * sense)), Change::SLIDE);
    }
  EXPECT_NEAR(law.reserve({T::force(8, -1.5), AREA}), 0.5, 1e-15);
  EXPECT_NEAR(law.reserve({T::force(8, 2.5), AREA}), -0.5, 1e-15);
  EXPECT_EQ(law.capacity(8, AREA), 2);
}

TYPED_TEST(TangentialLaws, LawsOfPressureTakeTheArea) {
  using T = TestFixture;
  EXPECT_EQ(T::tresca().capacity(1, AREA), 6);
  EXPECT_EQ(T::test(T::tresca(), NodeState::STICKING, T::force(1, 5.9)), Change::NONE);
  EXPECT_EQ(T::test(T::tresca(), NodeState::STICKING, T::force(1, 6.1)), Change::SLIDE);
  const double g = AREA * 0.5 * 20 / 1.5; // p = 20 = p0/2
  EXPECT_NEAR(T::formula().capacity(40, AREA), g, 1e-14);
  EXPECT_NEAR(T::formula().reserve({T::force(40, 3), AREA}), g - 3, 1e-14);
  EXPECT_EQ(T::test(T::formula(), NodeState::STICKING, T::force(40, g - 0.01)), Change::NONE);
  EXPECT_EQ(T::test(T::formula(), NodeState::STICKING, T::force(40, g + 0.01)), Change::SLIDE);
}

TYPED_TEST(TangentialLaws, SlipIsAgainstTheTraction) {
  using T = TestFixture;
  for (const auto& law : {T::coulomb(), T::tresca(), T::formula()}) {
    const typename T::Along m = law.slip_against(-3 * T::direction());
    expect_close(m, T::direction(), 1, 1e-15, "unit, against T");
    expect_close(law.slip_against(1e-30 * T::direction()), typename T::Along(-T::direction()), 1, 1e-15,
                 "tiny");
    EXPECT_EQ(law.slip_against(T::Along::Zero()).norm(), 1) << "no traction: some direction";
    const double g = law.capacity(8, AREA); // T = -m g is balanced
    EXPECT_NEAR(law.sliding_residual({{8, -g * m}, AREA}, m), 0, 1e-15);
    EXPECT_NEAR(law.sliding_residual({{8, g * m}, AREA}, m), 2 * g, 1e-14) << "along the slip";
    EXPECT_NEAR(law.sliding_residual({{8, T::Along::Zero()}, AREA}, m), g, 1e-14);
  }
}

TYPED_TEST(TangentialLaws, ASlidingNodeSticksWhenItSlipsBack) {
  using T = TestFixture;
  for (const auto& law : {T::coulomb(), T::tresca(), T::formula()}) {
    for (const double slip : {3., 1e-9, 0., -0.9e-4})
      EXPECT_EQ(T::test(law, NodeState::SLIDING, T::force(8, -2), slip), Change::NONE) << slip;
    for (const double slip : {-1.1e-4, -3.})
      EXPECT_EQ(T::test(law, NodeState::SLIDING, T::force(8, -2), slip), Change::STICK) << slip;
  }
  EXPECT_NEAR(T::Law::advance(-0.3 * T::direction(), T::direction()), -0.3, 1e-15);
}

TYPED_TEST(TangentialLaws, TensionReleasesASlidingNodeAndLetsAStickingOneSlide) {
  using T = TestFixture;
  for (const auto& law : {T::coulomb(), T::tresca(), T::formula()}) {
    EXPECT_EQ(T::test(law, NodeState::SLIDING, T::force(-0.9e-3, 0), 1), Change::NONE)
        << "within the tolerance";
    EXPECT_EQ(T::test(law, NodeState::SLIDING, T::force(-1.1e-3, 0), 1), Change::RELEASE);
    EXPECT_EQ(T::test(law, NodeState::SLIDING, T::force(-5, 0), -1), Change::RELEASE) << "rather than stick";
    for (const NodeState state : HELD) {
      EXPECT_EQ(T::test(law, state, T::force(-0.9e-3, 0)), Change::NONE);
      EXPECT_EQ(T::test(law, state, T::force(-1.1e-3, 0.9e-3)), Change::RELEASE)
          << "no direction to slide in";
      const double limit = law.capacity(4, AREA); // of a pressure as large
      EXPECT_EQ(T::test(law, state, T::force(-4, 1.001 * limit)), Change::SLIDE);
      EXPECT_EQ(T::test(law, state, T::force(-4, 0.999 * limit)),
                T::Dim == 3 ? Change::RELEASE : Change::SLIDE);
    }
  }
}

// Below N = 0 the capacity is that at N = 0; limit and residual go on as the law says.
TYPED_TEST(TangentialLaws, WithoutPressure) {
  using T = TestFixture;
  EXPECT_EQ(T::coulomb().capacity(0, AREA), 0);
  EXPECT_EQ(T::coulomb().capacity(-4, AREA), 0);
  EXPECT_EQ(T::formula().capacity(-4, AREA), 0);
  EXPECT_EQ(T::tresca().capacity(0, AREA), 6);
  EXPECT_EQ(T::tresca().capacity(-4, AREA), 6);
  EXPECT_NEAR(T::coulomb().reserve({T::force(-4, 0.5), AREA}), -1.5, 1e-15);
  EXPECT_NEAR(T::coulomb().sliding_residual({T::force(-4, 1), AREA}, T::direction()), 0, 1e-15);
  EXPECT_EQ(T::test(T::coulomb(), NodeState::STICKING, T::force(0, 2e-3)), Change::SLIDE);
  EXPECT_EQ(T::test(T::tresca(), NodeState::STICKING, T::force(0, 2e-3)), Change::NONE);
}

TYPED_TEST(TangentialLaws, Frictionless) {
  using T = TestFixture;
  const typename T::Law law(make_coulomb(0));
  EXPECT_TRUE(law.frictionless());
  EXPECT_FALSE(T::coulomb().frictionless());
  EXPECT_EQ(law.slip_against(T::direction()), T::Along::Zero());
  for (const double slip : {3., -3.})
    EXPECT_EQ(T::test(law, NodeState::SLIDING, T::force(8, 0), slip), Change::NONE) << "never sticks";
  EXPECT_EQ(T::test(law, NodeState::SLIDING, T::force(-1, 0)), Change::RELEASE);
  EXPECT_EQ(T::test(law, NodeState::STICKING, T::force(8, 2e-3)), Change::SLIDE);
  EXPECT_EQ(law.capacity(8, AREA), 0);
  EXPECT_NEAR(law.sliding_residual({T::force(8, 0.7), AREA}, T::Along::Zero()), 0.7, 1e-15);
}

TYPED_TEST(TangentialLaws, StickingAlways) {
  using T = TestFixture;
  const typename T::Law law(std::make_shared<StickingFriction>());
  for (const NodeState state : HELD) {
    for (const double N : {0., 1e-6, 8.})
      for (const double traction : {0., 2., 1e9})
        EXPECT_EQ(T::test(law, state, T::force(N, traction)), Change::NONE);
    EXPECT_EQ(T::test(law, state, T::force(-2e-3, 5)), Change::RELEASE) << "it never slides";
  }
  EXPECT_EQ(law.capacity(8, AREA), INF);
  EXPECT_EQ(law.reserve({T::force(8, 1e9), AREA}), INF);
  EXPECT_FALSE(law.frictionless());
}

TYPED_TEST(TangentialLaws, NoLaw) {
  expect_invalid([] { typename TestFixture::Law{nullptr}; }, "TangentialLaw: no friction law");
}

// At the limit, |T| = g, without slip: the residual T - g theta of METHOD.md (3.14) by differences is (I - H) dT + c H dD.
TEST(TangentialLaw, FirstTurnIsTheDerivativeAtTheLimit) {
  const double c = 3, g = 0.7, step = 1e-6;
  const Param<3> m(0.6, 0.8), T = -g * m;
  const SlipTurn<3> turn = TangentialLaw<3>::first_turn(m, Param<3>::Zero(), c);
  const auto residual = [&](const Param<3>& force, const Param<3>& slip) {
    return Param<3>(force - g * (force - c * slip).normalized());
  };
  for (int k = 0; k < 2; ++k) {
    const Param<3> e = step * Param<3>::Unit(k), none = Param<3>::Zero();
    const Param<3> by_T = (residual(T + e, none) - residual(T - e, none)) / (2 * step),
                   by_D = (residual(T, e) - residual(T, -e)) / (2 * step);
    EXPECT_LE((by_T - (Param<3>::Unit(k) - turn.H.col(k))).norm(), 1e-9);
    EXPECT_LE((by_D - turn.cHD.col(k)).norm(), 1e-9);
  }
  const Param<3> slip(0.01, 0.03);
  EXPECT_LE((TangentialLaw<3>::first_turn(m, slip, c).held - turn.cHD * slip).norm(), 1e-15);
  EXPECT_TRUE(TangentialLaw<3>::first_turn(m, Param<3>(-0.01 * m), c).H.isZero(0))
      << "it goes back: it sticks";
}

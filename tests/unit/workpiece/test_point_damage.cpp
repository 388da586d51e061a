// Events that damage and heal their points: rules, order, runs of a body, errors.
#include "run/run_body.hpp"
#include "unit/finite_difference.hpp"
#include "unit/workpiece/event_element.hpp"
#include "workpiece/healing.hpp"
#include "workpiece/point_fields.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// One triangle as a run sees it.
struct Body {
  RunBody<2> run;
  explicit Body(double yield_stress = 1.93e8)
      : run(std::make_unique<Workpiece<2>>(Element::mesh(3), Element::law(yield_stress))) {}
  Workpiece<2>& workpiece() { return run.workpiece(); }
  PointEvents<2>& user() { return run.user(); }
  PointDamage<2>& damage() { return run.damage(); }
  void define(const std::string& name, const std::string& formula,
              const std::map<std::string, double>& parameters = {}) {
    user().add(workpiece(), name, formula, parameters);
  }
  void go(double e, double dt = 1) {
    ASSERT_EQ(workpiece().update(homogeneous(workpiece().discretization(), stretch(e)), dt, 0).status,
              UpdateStatus::OK);
    run.accept();
  }
  double w() { return integrity_of(workpiece().state(), 0); }
};

} // namespace

// The event's own step is still whole; then equal parts, and the event comes once.
TEST(PointDamage, BeginsInTheStepAfterTheEvent) {
  Body body(NEVER_YIELDS);
  body.define("crumble", "x - 0.68"); // place of the point, 2/3 at rest
  EXPECT_FALSE(body.run.has_damage());
  body.damage().damage(body.workpiece(), body.user(), "crumble", 0.1, 3);
  EXPECT_TRUE(body.run.has_damage());
  const double stretches[] = {0.01, 0.03, 0.03, 0.03, 0.04, 0.05}, expected[] = {1, 1, 0.7, 0.4, 0.1, 0.1};
  for (int k = 0; k < 6; ++k) {
    body.go(stretches[k]);
    EXPECT_NEAR(body.w(), expected[k], 1e-15) << "step " << k;
  }
  EXPECT_EQ(body.user().number("crumble"), 1);
}

// Crumbles, heals, and crumbles again: plastic strain begins anew with what has healed.
TEST(PointDamage, HealedPointsCrumbleAgain) {
  Body body;
  body.define("crumble", "ep - 0.01");
  body.define("mend", "syy - sxx - c", {{"c", 1e8}}); // flow turned round
  body.damage().damage(body.workpiece(), body.user(), "crumble", 1e-3, 1);
  body.damage().heal(body.user(), "mend", 2);
  body.go(0.02);
  EXPECT_EQ(body.user().number("crumble"), 1);
  EXPECT_EQ(body.w(), 1);
  body.go(0.02);
  EXPECT_EQ(body.w(), 1e-3);
  body.go(0.01);
  EXPECT_EQ(body.user().number("mend"), 1);
  EXPECT_EQ(body.w(), 1e-3);
  body.go(0.01);
  EXPECT_NEAR(body.w(), 0.5005, 1e-15);
  body.go(0.01);
  EXPECT_EQ(body.w(), 1);
  EXPECT_LT(internal_field(body.workpiece(), "plastic_strain_eq")[0], 1e-4);
  body.go(0.03);
  EXPECT_EQ(body.user().number("crumble"), 2);
  body.go(0.03);
  EXPECT_EQ(body.w(), 1e-3);
}

// Healing before the end of the damage takes over; whole points do not heal; a later rule may take more.
TEST(PointDamage, TheLaterEventOfAPointCounts) {
  Body body(NEVER_YIELDS);
  for (const char* name : {"a", "b", "c", "d"})
    body.define(name, "x - 2/3*(1 + e)", {{"e", 0.01 * (name[0] - 'a') + 0.005}});
  body.damage().damage(body.workpiece(), body.user(), "b", 0.5, 2);
  body.damage().heal(body.user(), "a", 1);
  body.damage().heal(body.user(), "c", 1);
  body.damage().damage(body.workpiece(), body.user(), "d", 0.2, 4);
  body.go(0.01); // a: nothing to heal
  EXPECT_EQ(body.workpiece().state().integrity_rate[0], 0);
  body.go(0.02); // b
  body.go(0.03); // c, with w = 0.75
  EXPECT_NEAR(body.w(), 0.75, 1e-15);
  body.go(0.03);
  EXPECT_EQ(body.w(), 1);
  body.go(0.01);
  body.go(0.04); // b, c, d in one step: d is the last
  body.go(0.04);
  EXPECT_NEAR(body.w(), 0.8, 1e-15);
}

// At once, whatever the events say; between steps only.
TEST(PointDamage, HealsTheWholeBody) {
  Workpiece<2> plain(Element::mesh(3), Element::law(1.93e8)), body(Element::mesh(6), Element::law(1.93e8));
  expect_invalid([&] { heal_all(plain, 1); }, "nothing to heal");
  body.track_integrity();
  EXPECT_EQ(heal_all(body, 1), 0);
  body.change_integrity(0, 0.5, 1);
  body.change_integrity(2, 0.1, 1);
  const auto update = [&] { body.update(homogeneous(body.discretization(), stretch(1e-3)), 1, 0); };
  update();
  expect_invalid([&] { heal_all(body, 1); }, "a step is under way");
  body.accept();
  expect_invalid([&] { heal_all(body, 0); }, "steps = 0");
  EXPECT_EQ(heal_all(body, 2), 2);
  update();
  EXPECT_EQ(body.state().integrity, (std::vector<double>{0.75, 1, 0.55}));
}

// A copy of the body's state goes on to the same bits, from the middle of a change.
TEST(PointDamage, ACopyGoesOn) {
  Body body, copy;
  for (Body* each : {&body, &copy}) {
    each->define("crumble", "ep - 0.005");
    each->define("mend", "syy - sxx - 1e8");
    each->damage().damage(each->workpiece(), each->user(), "crumble", 0.01, 3);
    each->damage().heal(each->user(), "mend", 3);
  }
  for (const double e : {0.01, 0.012, 0.013}) body.go(e);
  copy.run.set_state(body.run.state());
  for (const double e : {0.014, 0.004, 0.004, 0.004, 0.02, 0.02}) {
    body.go(e);
    copy.go(e);
    EXPECT_TRUE(same(body.workpiece().state(), copy.workpiece().state()));
  }
  EXPECT_EQ(body.user().counts("crumble"), copy.user().counts("crumble"));
  EXPECT_EQ(body.user().number("mend"), 1);
}

TEST(PointDamage, Errors) {
  Body body;
  body.define("crumble", "ep - 0.1");
  body.define("mend", "1 - sxx");
  PointDamage<2>& rules = body.damage();
  const auto damage = [&](const std::string& name, double w, int steps) {
    rules.damage(body.workpiece(), body.user(), name, w, steps);
  };
  expect_invalid([&] { rules.heal(body.user(), "mend", 1); }, "\"mend\" has nothing to heal");
  expect_invalid([&] { damage("crumbles", 0.1, 1); }, "no event \"crumbles\", expected one of crumble, mend");
  expect_invalid([&] { damage("crumble", 0, 1); },
                 "integrity = 0, expected 0 < integrity < 1; at 0 nodes would have no stiffness");
  expect_invalid([&] { damage("crumble", 1, 1); }, "integrity = 1");
  expect_invalid([&] { damage("crumble", 0.1, 0); }, "steps = 0, expected >= 1");
  EXPECT_FALSE(body.workpiece().state().tracks_integrity()) << "nothing has changed";
  damage("crumble", 0.1, 1);
  expect_invalid([&] { damage("crumble", 0.2, 1); }, "\"crumble\" damages or heals already");
  expect_invalid([&] { rules.heal(body.user(), "crumble", 1); }, "\"crumble\" damages or heals already");
  expect_invalid([&] { rules.heal(body.user(), "mend", 0); }, "steps = 0");
  Body users;
  users.define("crumble", "ep - 0.1");
  users.workpiece().set_user_defined(true);
  users.damage().damage(users.workpiece(), users.user(), "crumble", 0.1, 1);
  EXPECT_TRUE(users.run.has_damage());
  users.run.start();
  users.define("mend", "ep - 0.2");
  users.damage().heal(users.user(), "mend", 1);
  expect_invalid([&] { users.run.start(); }, "an event heals, expected damage only: the law is user-defined");
}

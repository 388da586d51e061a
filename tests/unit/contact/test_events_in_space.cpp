// Events of a node on a plate in space: the norm of a tangential force that turns, and a direction of slip that turns.
#include "contact/events.hpp"
#include "geometry/plane_surface.hpp"
#include "kinematics/cartesian_in_space.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double MU = 0.3;

/// One node under a plate that faces down, in contact; the step leads from t = 10 to 12.
struct PlateScene {
  ContactModel<3> model;
  BodyView<3> body;
  ContactState<3> start, end;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3), R0 = u, R1 = u;
  EventSearch tolerance{{1e-9, 1e-9, 1e-9}, 1e-3};

  explicit PlateScene(NodeState state) {
    const auto plate = std::make_shared<PlaneSurface>(Vector<3>(0, 0, 0), Vector<3>(0.1, 0, -1), 1);
    model.tools = {std::make_shared<Tool<3>>("plate", plate, std::make_shared<CartesianInSpace>())};
    model.laws.emplace_back(make_coulomb(MU));
    model.first = {0, 6};
    model.candidates = {0};
    body.X = u;
    body.fixed.assign(3, 0);
    body.spacing = 1;
    start.q = Eigen::VectorXd::Zero(6);
    start.nodes.resize(1);
    start.nodes[0].state = state;
    start.nodes[0].tool = 0;
    place_at(start.nodes[0], SurfacePlace<3>{});
    end = start;
  }
  SurfaceFrame<3> frame() const { return model.tools[0]->surface().frame(start.nodes[0].place); }
  Vector<3> force(double N, const Param<3>& T) const { return N * frame().n + frame().E * T; }
  std::vector<ContactEvent<3>> earliest() const {
    return earliest_events(model, body, {&start, &end, &u, &u, &R0, &R1, 10, 2}, tolerance);
  }
};

} // namespace

TEST(EventsInSpace, NormOfALinearForceMeetsTheCone) {
  const Param<3> ends[][2] = {{{0.2, 0}, {0, 0.9}},   {{0.29, 0.05}, {-0.8, 0}}, {{0, -0.25}, {0.1, 0.5}},
                              {{0.1, 0.1}, {0.4, 0}}, {{0, 0}, {0.6, -0.2}},     {{0.2, 0.1}, {0.2, 0.1}}};
  for (const auto& T : ends)
    for (const double N1 : {0.3, 1., 1.4}) {
      PlateScene s(NodeState::STICKING);
      s.R0 = s.force(1, T[0]);
      s.R1 = s.force(N1, T[1]);
      const auto events = s.earliest();
      if (T[1].norm() < MU * N1) { // both ends inside: so is all between them
        EXPECT_TRUE(events.empty());
        continue;
      }
      ASSERT_EQ(events.size(), 1u);
      EXPECT_STREQ(name_of(events[0].kind), "stick-to-slip");
      const double f = events[0].fraction;
      EXPECT_NEAR(events[0].t, 10 + 2 * f, 1e-12);
      EXPECT_NEAR((T[0] + f * (T[1] - T[0])).norm(), MU * (1 + f * (N1 - 1)), 1e-12) << "at " << f;
      EXPECT_TRUE(f > 0 && f < 1) << f;
      EXPECT_LE((events[0].slip_direction + s.frame().E * T[1].normalized()).norm(), 1e-12);
    }
}

// It stops where the power of friction changes its sign: against the direction that it has by then, not that of the start.
TEST(EventsInSpace, SlipStopsAgainstTheDirectionThatHasTurned) {
  for (const bool back : {true, false}) {
    PlateScene s(NodeState::SLIDING);
    const Param<3> before(1, 0), now(-0.5, 0.8);
    s.start.nodes[0].slip_direction = s.frame().E * before;
    s.start.nodes[0].slip_rate = 0.03;
    s.end.nodes[0].slip_direction = s.frame().E * now.normalized();
    s.R0 = s.force(1, -MU * before);
    s.R1 = s.force(1, -MU * now.normalized());
    auto& place = s.end.nodes[0].place;
    place = s.model.tools[0]->surface().moved(place, Param<3>((back ? -0.02 : 0.02) * now.normalized()));
    const auto events = s.earliest();
    ASSERT_EQ(events.size(), back ? 1u : 0u);
    if (!back) continue;
    EXPECT_STREQ(name_of(events[0].kind), "slip-to-stick");
    EXPECT_NEAR(events[0].fraction, 1.5 * 0.03 / (0.03 + 0.01) - 0.5, 1e-9); // METHOD.md (4.2)
  }
}

// The log of a run: events of nodes and of quadrature points, in the order of time.
#include "run/event_log.hpp"
#include <gtest/gtest.h>

using namespace burnish;

namespace {

template <class Dimension> struct EventLogs : testing::Test {
  static constexpr int Dim = Dimension::value;
  EventLog<Dim> log;

  static ContactEvent<Dim> touch(double t, int candidate) {
    ContactEvent<Dim> event;
    event.t = t;
    event.candidate = candidate;
    event.node = 10 * candidate;
    event.tool = 1;
    return event;
  }
  static ElementEvent<Dim> element(double fraction, int point, PointChange change = PointChange::YIELD) {
    return {fraction, change, point, Vector<Dim>::Constant(0.5 * point)};
  }
  std::vector<double> times() const {
    std::vector<double> list;
    for (const auto& event : log.events) list.push_back(event.t);
    return list;
  }
  /// Node or quadrature point of each.
  std::vector<int> who() const {
    std::vector<int> list;
    for (const auto& event : log.events) list.push_back(event.node);
    return list;
  }
};
using Both = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(EventLogs, Both);

using Times = std::vector<double>;
using Nodes = std::vector<int>;

} // namespace

TYPED_TEST(EventLogs, ElementEventsBecomeEventsOfTheRun) {
  constexpr int Dim = TestFixture::Dim;
  ElementEvent<Dim> damage = this->element(0.75, 6, PointChange::USER);
  damage.name = "damage";
  this->log.add({this->element(0.25, 3), this->element(0.5, 4, PointChange::UNLOADING), damage}, 10, 2);
  ASSERT_EQ(this->log.events.size(), 3u);
  EXPECT_EQ(this->times(), (Times{10.5, 11, 11.5}));
  EXPECT_EQ(this->who(), (Nodes{3, 4, 6}));
  const char* kinds[] = {"yield", "unloading", "damage"};
  for (int k = 0; k < 3; ++k) {
    const auto& event = this->log.events[k];
    EXPECT_EQ(kind_of(event), kinds[k]);
    EXPECT_EQ(event.candidate, -1);
    EXPECT_EQ(event.tool, -1);
    EXPECT_EQ(event.fraction, 0.25 * (k + 1));
    EXPECT_EQ(event.x, (Vector<Dim>::Constant(0.5 * event.node)));
  }
}

TYPED_TEST(EventLogs, ContactEventsStayAsTheyAre) {
  auto event = this->touch(3, 4);
  event.kind = EventKind::RELEASE;
  event.x.setConstant(0.25);
  this->log.add({event});
  this->log.add(std::vector<ContactEvent<TestFixture::Dim>>());
  ASSERT_EQ(this->log.events.size(), 1u);
  EXPECT_EQ(kind_of(this->log.events[0]), "release");
  EXPECT_EQ(this->log.events[0].node, 40);
  EXPECT_EQ(this->log.events[0].tool, 1);
  EXPECT_EQ(this->log.events[0].x[1], 0.25);
}

// Yield, unloading and user-defined events of a step are found one after another.
TYPED_TEST(EventLogs, ElementEventsOfOneStepAreSorted) {
  this->log.add({this->element(0.2, 1), this->element(0.8, 2)}, 0, 1);
  this->log.add({this->element(0.1, 3), this->element(0.8, 4), this->element(0.9, 5)}, 0, 1);
  EXPECT_EQ(this->times(), (Times{0.1, 0.2, 0.8, 0.8, 0.9}));
  EXPECT_EQ(this->who(), (Nodes{3, 1, 2, 4, 5})) << "at one instant in the order in which they came";
  this->log.add({this->element(0.5, 6), this->element(0, 7)}, 1, 1);
  EXPECT_EQ(this->times(), (Times{0.1, 0.2, 0.8, 0.8, 0.9, 1, 1.5}));
}

// An implicit step tells of its nodes in the order of the candidates, after its quadrature points.
TYPED_TEST(EventLogs, ContactEventsAreSortedIntoTheirStep) {
  this->log.add({this->touch(0.9, 1)});
  this->log.add({this->element(0.2, 1), this->element(0.8, 2)}, 1, 1);
  this->log.add({this->touch(1.9, 2), this->touch(1.5, 3), this->touch(1, 4), this->touch(1.5, 5)});
  EXPECT_EQ(this->times(), (Times{0.9, 1, 1.2, 1.5, 1.5, 1.8, 1.9}));
  EXPECT_EQ(this->who(), (Nodes{10, 40, 1, 30, 50, 2, 20}))
      << "at one instant in the order in which they came";
}

TYPED_TEST(EventLogs, ElementEventsAreSortedAmongThoseOfNodes) {
  this->log.add({this->touch(0.3, 1), this->touch(0.6, 2)});
  this->log.add({this->element(0.25, 1), this->element(0.5, 2), this->element(0.75, 3)}, 0, 1);
  EXPECT_EQ(this->times(), (Times{0.25, 0.3, 0.5, 0.6, 0.75}));
}

// Mirrored nodes slip at one instant but for rounding.
TYPED_TEST(EventLogs, RoundingDoesNotOrder) {
  this->log.add({this->touch(0.5, 3), this->touch(0.5 * (1 - 1e-15), 4), this->touch(0.5 * (1 + 1e-15), 1)});
  EXPECT_EQ(this->who(), (Nodes{30, 40, 10}));
}

// The state of user-defined events as one value.
#include "unit/workpiece/event_element.hpp"

using namespace burnish;
using namespace burnish::test;

TEST(PointEventsState, ACopyOfTheStateGoesOnTheSame) {
  Element first(NEVER_YIELDS);
  first.step_to(stretch(0.01));
  const std::map<std::string, double> half = {{"c", 0.5 * first.stress()[0]}};
  first.body.revert();
  first.add("sxx - c", "user", half);
  for (double e : {0.01, 0.002}) first.go_to(stretch(e));
  Element second(NEVER_YIELDS);
  second.add("sxx - c", "user", half);
  second.body.set_state(first.body.state());
  second.events.set_state(first.events.state());
  for (double e : {0.008, 0.001, 0.009})
    for (Element* element : {&first, &second}) element->go_to(stretch(e));
  EXPECT_EQ(first.events.number("user"), 3);
  EXPECT_EQ(second.events.counts("user"), first.events.counts("user"));
  const auto refused = [&](auto change, const std::string& text) {
    PointEventsState state = first.events.state();
    change(state);
    expect_invalid([&] { second.events.set_state(state); }, "PointEvents::set_state: " + text);
  };
  refused([](auto& s) { s.clear(); }, "number of events = 0, expected 1");
  refused([](auto& s) { s[0].name = "other"; }, "name = other, expected user");
  refused([](auto& s) { s[0].count.pop_back(); }, "number of points of above and count = 0, expected 1");
}

TEST(PointEventsState, AFormulaThatFailsInAcceptLeavesTheStateAsItWas) {
  Element element(NEVER_YIELDS);
  element.add("-sxx - 1e6", "first");
  element.add("log(1 + 2*x - 2*X0) - 1", "late", {{"X0", 2. / 3}});
  element.step_to(tensor(0.1, 0, 0, 1));
  EXPECT_THROW(element.events.accept(element.body), std::invalid_argument);
  EXPECT_EQ(element.events.number("first"), 0);
  EXPECT_EQ(element.events.state()[0].above[0], 0);
}

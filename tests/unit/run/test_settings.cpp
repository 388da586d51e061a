// The table of settings: defaults lie in their ranges, values reach their members, others are refused.
#include "run/settings.hpp"
#include <gtest/gtest.h>
#include <set>

using namespace burnish;

namespace {

template <class Call> std::string error_of(Call&& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SettingsTable, NamesAreUniqueAndDefaultsAllowed) {
  std::set<std::string> names;
  for (const Setting& one : settings()) {
    SCOPED_TRACE(one.name);
    EXPECT_TRUE(names.insert(one.name).second);
    Settings all;
    if (const auto real = std::get_if<double& (*)(Settings&)>(&one.member)) {
      EXPECT_TRUE((*real)(all) == 0 || one.range.holds((*real)(all)));
    }
    if (const auto integer = std::get_if<int& (*)(Settings&)>(&one.member)) {
      EXPECT_TRUE(one.range.holds((*integer)(all)));
    }
    if (const auto choice = std::get_if<Choice>(&one.member)) {
      EXPECT_EQ("\"" + choice->words[static_cast<std::size_t>(choice->get(all))] + "\"", one.otherwise);
    }
  }
}

TEST(SettingsTable, ValuesReachTheirMembers) {
  Settings all;
  set_number(all, setting("tolerance"), 1e-6, "test", "tolerance");
  set_number(all, setting("stepsperfactor"), 4, "test", "stepsperfactor");
  set_number(all, setting("tied"), 1, "test", "tied");
  set_choice(all, setting("scheme"), "article", "test");
  set_choice(all, setting("elementevents"), "log", "test");
  EXPECT_EQ(all.iteration.tolerance, 1e-6);
  EXPECT_EQ(all.iteration.steps_per_factor, 4);
  EXPECT_TRUE(all.iteration.tied);
  EXPECT_EQ(all.stepper.scheme, Scheme::ARTICLE);
  EXPECT_EQ(all.stepper.events.elements, ElementEvents::LOG);
}

TEST(SettingsTable, OthersAreRefused) {
  Settings all;
  const auto number = [&](const char* name, double value) {
    return error_of([&] { set_number(all, setting(name), value, "test", name); });
  };
  EXPECT_EQ(number("tolerance", 1), "test: tolerance = 1, expected 0 < value < 1");
  EXPECT_EQ(number("memory", 2.5), "test: memory = 2.5, expected a whole number");
  EXPECT_EQ(number("maxiterations", 2e6), "test: maxiterations = 2000000, expected 1 to 1000000");
  EXPECT_NE(number("dtmax", std::nan("")), "");
  EXPECT_EQ(error_of([&] { set_choice(all, setting("terms"), "some", "test"); }),
            "test: unknown terms \"some\", expected \"complete\", \"article\" or \"none\"");
  EXPECT_EQ(error_of([&] { setting("speed"); }), "setting: there is none named \"speed\"");
}

} // namespace

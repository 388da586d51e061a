// The table of shapes: every kind can be made by name, and says what it takes.
#include "cad/occ/cad_curve.hpp"
#include "geometry/circle.hpp"
#include "shapes/shapes.hpp"
#include "unit/finite_difference.hpp"
#include <set>

using namespace burnish;
using namespace burnish::test;

namespace {

const Param<2> ANY(0.0);

void refuses(const Arguments& arguments, const std::string& message) {
  expect_invalid([&] { make_shape(arguments); }, message);
}

Arguments cad(const std::string& file) {
  Arguments arguments;
  arguments.texts["cad"] = file;
  return arguments;
}

} // namespace

TEST(Shapes, TheTableIsWhole) {
  std::set<std::string> chosen;
  std::map<std::string, ArgumentKind> values;
  for (const ShapeKind& kind : shape_kinds()) {
    ASSERT_FALSE(kind.parameters.empty());
    const std::string first = kind.parameters[0].name;
    EXPECT_TRUE(chosen.insert(first).second) << first << " chooses two kinds";
    EXPECT_EQ(kind.example.rfind(first + "=", 0), 0u) << kind.example;
    for (const Parameter& parameter : kind.parameters) {
      EXPECT_GT(parameter.help.size(), 10u) << parameter.name;
      EXPECT_EQ(parameter.help.find('\n'), std::string::npos) << parameter.name;
      EXPECT_EQ(parameter.name.find('_'), std::string::npos) << "no name for a script";
      const auto known = values.emplace(parameter.name, parameter.kind);
      EXPECT_EQ(known.first->second, parameter.kind) << parameter.name << " is of two types";
      EXPECT_NE(shape_help().find(parameter.help), std::string::npos) << parameter.name;
    }
  }
  for (const SurfaceKind& kind : surface_kinds())
    for (const Parameter& parameter : kind.parameters) values.emplace(parameter.name, parameter.kind);
  EXPECT_EQ(shape_parameters().size(), values.size());
  for (const std::string& first : chosen) {
    int kinds = 0;
    for (const ShapeKind& kind : shape_kinds())
      for (const Parameter& parameter : kind.parameters) kinds += parameter.name == first;
    EXPECT_EQ(kinds, 1) << first << " is an option of another kind";
  }
}

TEST(Shapes, EachKind) {
  Arguments circle, line, chain;
  circle.numbers["circle"] = 2;
  EXPECT_NEAR(make_shape(circle)->closest_point({5, 0}, ANY).gap, 3, 1e-15);
  circle.flags["inside"] = true;
  EXPECT_NEAR(make_shape(circle)->closest_point({0.5, 0}, ANY).gap, 1.5, 1e-15);
  line.lists["line"] = {0, 0, 4, 0};
  EXPECT_NEAR(make_shape(line)->closest_point({1, 2}, ANY).gap, 2, 1e-15);
  chain.lists["chain"] = {1, 1, 1, -1, 1, 1, -1, -1, 1, 1, -1, 1};
  chain.flags["closed"] = true;
  EXPECT_NEAR(make_shape(chain)->closest_point({3, 0}, ANY).gap, 2, 1e-14);
  Arguments roller = cad("tests/support/cad/circle.step");
  roller.numbers["scale"] = 0.1;
  roller.lists["curves"] = {1};
  EXPECT_NEAR(make_shape(roller)->tightest_radius(), 1.5, 1e-13);
  Arguments punch = cad("tests/support/cad/punch.geo");
  punch.texts["geo"] = "R=1; H=7";
  EXPECT_NEAR(make_shape(punch)->tightest_radius(), 1, 1e-13);
}

TEST(ShapesErrors, NoneOrSeveralOrOthersParameters) {
  Arguments two, closed, turned;
  const std::string one = "shape: give exactly one profile: circle=R, line=[x0,y0,x1,y1], chain=[x0,y0,r0, "
                          "x1,y1,r1, ...] or cad=\"file\"";
  refuses({}, one);
  two.numbers["circle"] = 1;
  two.lists["line"] = {0, 0, 1, 0};
  refuses(two, one);
  closed.numbers["circle"] = 1;
  closed.flags["closed"] = false;
  refuses(closed, "shape: circle= takes no closed=");
  turned.lists["line"] = {0, 0, 1, 0};
  turned.flags["inside"] = true;
  refuses(turned, "shape: line= takes no inside=; swap the ends of a line to turn it");
}

TEST(ShapesErrors, Values) {
  Arguments line, chain, roller = cad("tests/support/cad/circle.step");
  line.lists["line"] = {0, 0, 1};
  refuses(line, "line: number of values in line = 3, expected 4: [x0,y0,x1,y1]");
  for (const std::size_t n : {0, 4}) {
    chain.lists["chain"].assign(n, 0);
    refuses(chain, "chain: number of values in chain = " + std::to_string(n) + ", expected three per point");
  }
  roller.lists["curves"] = {};
  refuses(roller, "cad: curves is an empty array: name curves, or leave it out to take all");
  for (const double tag : {0.5, 1e10, std::nan("")}) {
    roller.lists["curves"] = {tag};
    refuses(roller, "cad: tag in curves = ");
  }
}

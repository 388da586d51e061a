// Events by a formula on the state of a point: roots on known paths, firing again, several at once, errors.
#include "unit/workpiece/event_element.hpp"
#include "workpiece/point_fields.hpp"
#include <Eigen/Eigenvalues>
#include <numeric>

using namespace burnish;
using namespace burnish::test;

namespace {

/// Fraction of the only event of the step, NaN if there is not exactly one.
double fraction(const std::vector<ElementEvent<2>>& events) {
  EXPECT_EQ(events.size(), 1u);
  return events.size() == 1 ? events[0].fraction : std::nan("");
}

} // namespace

// Plastic strain is linear between the two known ends.
TEST(PointEvents, RootOfThePlasticStrain) {
  Element element;
  element.go_to(stretch(0.01));
  const double start = element.plastic_strain_eq();
  element.add("ep - c", "strained", {{"c", start + 1e-3}});
  element.step_to(stretch(0.02));
  const double end = element.plastic_strain_eq();
  ASSERT_GT(end, start + 2e-3);
  const auto found = element.find();
  EXPECT_NEAR(fraction(found), 1e-3 / (end - start), 1e-12);
  EXPECT_EQ(found[0].change, PointChange::USER);
  EXPECT_EQ(found[0].name, "strained");
  EXPECT_EQ(found[0].point, 0);
}

// Simple shear from rest: every stress is proportional to the fraction, whatever the formula makes of it.
TEST(PointEvents, RootsOfCurvedFormulas) {
  Element element(NEVER_YIELDS);
  element.step_to(shear(0.1));
  const double c = 0.1 * element.stress()[3];
  element.body.revert();
  for (const char* formula : {"sxy - 3*c", "sxy^2 - 9*c^2", "exp(sxy/c) - exp(3)", "sqrt(sxy) - sqrt(3*c)",
                              "step(sxy - 3*c) - 0.5", "tanh(9*(sxy/c - 3))", "1/3.001 - 1/(sxy/c + 1e-3)"})
    element.add(formula, formula, {{"c", c}});
  element.step_to(shear(0.1));
  const auto found = element.find();
  ASSERT_EQ(found.size(), 7u);
  for (const auto& event : found) EXPECT_NEAR(event.fraction, 0.3, 1e-9) << event.name;
}

// Every name against the same quantity computed another way.
TEST(PointEvents, WhatTheNamesMean) {
  for (int nodes : {3, 6}) {
    Element element(NEVER_YIELDS, nodes);
    const Tensor<2> F = tensor(1.02, 0.03, -0.01, 0.99);
    element.step_to(F);
    const Stress<2> t = element.stress();
    Eigen::Matrix3d sigma;
    sigma << t[0], t[3], 0, t[3], t[1], 0, 0, 0, t[2];
    const Eigen::Vector3d principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sigma).eigenvalues();
    const std::map<std::string, double> expected = {{"seq", stress_eq_field(element.body)[0]},
                                                    {"sm", sigma.trace() / 3},
                                                    {"sxx", t[0]},
                                                    {"syy", t[1]},
                                                    {"szz", t[2]},
                                                    {"sxy", t[3]},
                                                    {"s1", principal[2]},
                                                    {"s3", principal[0]}};
    element.body.revert();
    for (const auto& [name, value] : expected) element.add(name + "/v - 0.3", name, {{"v", value}});
    const Vector<2> X(element.body.discretization().point[0], element.body.discretization().point[1]);
    const Vector<2> moved = F * X - X;
    element.add("(x - x0)/v - 0.3", "x", {{"x0", X[0]}, {"v", moved[0]}});
    element.add("(y - y0)/v - 0.3", "y", {{"y0", X[1]}, {"v", moved[1]}});
    element.step_to(F);
    std::size_t at_first = 0;
    for (const auto& event : element.find()) {
      if (event.point != 0) continue;
      ++at_first;
      EXPECT_NEAR(event.fraction, 0.3, 1e-9) << event.name;
      EXPECT_NEAR((event.x - X - 0.3 * moved).norm(), 0, 1e-9) << event.name;
    }
    EXPECT_EQ(at_first, expected.size() + 2);
    EXPECT_EQ(PointVariables<2>(element.body.law()).names().size(), expected.size() + 3)
        << "ep has its own test";
  }
}

TEST(PointEvents, FiresAgainOnlyAfterFallingBelow) {
  Element element(NEVER_YIELDS);
  element.step_to(stretch(0.01));
  element.add("sxx - c", "user", {{"c", 0.5 * element.stress()[0]}});
  element.body.revert();
  const double way[] = {0.004, 0.01, 0.008, 0.02, 0.004, 0.003, 0.012, 0.015};
  const int expected[] = {0, 1, 1, 1, 1, 1, 2, 2};
  for (int k = 0; k < 8; ++k) {
    element.go_to(stretch(way[k]));
    EXPECT_EQ(element.events.number("user"), expected[k]) << "step " << k;
  }
  EXPECT_EQ(element.events.counts("user"), std::vector<int>{2});
}

// The von Mises stress falls to nothing and rises again while the stress changes its sign.
TEST(PointEvents, FallsAndRisesInOneStep) {
  Element element(NEVER_YIELDS);
  element.step_to(stretch(0.01));
  const double c = 0.5 * stress_eq_field(element.body)[0];
  element.body.revert();
  element.add("seq - c", "user", {{"c", c}});
  element.go_to(stretch(0.01));
  EXPECT_EQ(element.events.number("user"), 1);
  element.step_to(stretch(-0.01));
  const double q0 = 2 * c, q1 = stress_eq_field(element.body)[0]; // through zero at q0/(q0 + q1)
  EXPECT_NEAR(fraction(element.find()), (q0 + c) / (q0 + q1), 1e-12);
  element.accept();
  EXPECT_EQ(element.events.number("user"), 2);
}

TEST(PointEvents, AboveFromTheBeginning) {
  Element element(NEVER_YIELDS);
  element.add("1 - sxx", "low"); // Pa
  element.go_to(stretch(-0.01));
  EXPECT_EQ(element.events.number("low"), 0);
  element.go_to(stretch(0.01));
  element.go_to(stretch(-0.01));
  EXPECT_EQ(element.events.number("low"), 1);
}

// Cut at the event, the step ends there, and the event is taken, once.
TEST(PointEvents, CutAtTheEvent) {
  for (const double overshoot : {0., 1e-3}) {
    Element element;
    element.go_to(stretch(0.01));
    element.add("exp(60*ep) - 2"); // ep = ln 2/60 = 0.01155
    element.step_to(stretch(0.04));
    EXPECT_EQ(element.earliest(overshoot, 0.9), 2) << "none beyond 0.9";
    const double f = element.earliest(overshoot, 0);
    ASSERT_GT(f, 0.1);
    ASSERT_LT(f, 0.9);
    element.body.revert();
    element.events.revert();
    element.step_to(stretch(0.01 + 0.03 * f));
    const double reached = element.plastic_strain_eq();
    EXPECT_NEAR(reached, std::log(2.) / 60, 1e-4);
    ASSERT_NE(reached, std::log(2.) / 60);
    const double g = element.earliest(0.01, 0);
    EXPECT_NEAR(g, 1, 1e-2) << "with the overshoot it is there";
    element.accept();
    EXPECT_EQ(element.events.number("user"), 1);
    element.go_to(stretch(0.04));
    EXPECT_EQ(element.events.number("user"), 1) << "not again";
  }
}

TEST(PointEvents, OvershootIsForgotten) {
  Element element(NEVER_YIELDS);
  element.step_to(stretch(0.01));
  element.add("sxx - c", "user", {{"c", 1.0005 * element.stress()[0]}});
  EXPECT_TRUE(element.find().empty());
  EXPECT_EQ(element.earliest(1e-4, 0), 2);
  EXPECT_EQ(element.earliest(1e-3, 0), 1);
  EXPECT_EQ(fraction(element.find()), 1);
  element.body.revert();
  element.events.revert();
  element.go_to(stretch(0.01));
  EXPECT_EQ(element.events.number("user"), 0);
  element.step_to(stretch(0.02));
  EXPECT_EQ(element.earliest(1e-3, 0.1), 2) << "it lies at 0.0005";
  element.accept();
  EXPECT_EQ(element.events.number("user"), 1);
}

TEST(PointEvents, SeveralByTheirTime) {
  Workpiece<2> body(patch(6, 1), Element::law(NEVER_YIELDS));
  PointEvents<2> events;
  events.add(body, "half", "seq - 1.5e8");
  events.add(body, "tension", "s1 - c", {{"c", 1e8}});
  events.add(body, "never", "seq - 1e12");
  body.update(bent(body.discretization(), 1, 0.01), 1, 0);
  const auto found = events.find(body);
  std::map<std::string, int> number;
  for (std::size_t k = 0; k < found.size(); ++k) {
    ++number[found[k].name];
    EXPECT_LE(found[k > 0 ? k - 1 : 0].fraction, found[k].fraction);
  }
  EXPECT_GT(number["half"], 10);
  EXPECT_GT(number["tension"], 10);
  EXPECT_EQ(number["never"], 0);
  events.accept(body);
  for (const auto& [name, count] : number) EXPECT_EQ(events.number(name), count);
  const std::vector<int>& counts = events.counts("half");
  EXPECT_EQ(counts.size(), static_cast<std::size_t>(body.discretization().num_points()));
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0), number["half"]);
}

// A yield condition as formula, on a body that stays elastic, against the yield events of one that yields:
// they differ by the rotation of the stress inside the step only, that is by the size of the step.
TEST(PointEvents, YieldConditionAsFormula) {
  std::vector<double> errors;
  for (const double size : {0.02, 0.01, 0.005}) {
    const double yield = 2e10 * size;
    Workpiece<2> yields(patch(6, 1), Element::law(yield)), elastic(patch(6, 1), Element::law(NEVER_YIELDS));
    PointEvents<2> events;
    events.add(elastic, "user", "seq - Y", {{"Y", yield}});
    const Eigen::VectorXd u = bent(yields.discretization(), 1, size);
    yields.update(u, 1, 0);
    elastic.update(u, 1, 0);
    std::map<int, double> located;
    for (const auto& event : element_events<2>(yields, 0)) located[event.point] = event.fraction;
    const auto found = events.find(elastic);
    ASSERT_GT(found.size(), 10u);
    ASSERT_EQ(found.size(), located.size());
    double error = 0;
    for (const auto& event : found)
      error = std::max(error, std::abs(event.fraction - located.at(event.point)));
    EXPECT_LT(error, size);
    errors.push_back(error);
  }
  for (int k : {1, 2}) EXPECT_NEAR(errors[k] / errors[k - 1], 0.5, 0.05) << "first order in the step";
}

// The criterion of the header's kind on a body without stress, where sm/seq is 0/0.
TEST(PointEvents, TriaxialityAtRest) {
  Element element;
  element.add("ep - D*exp(-1.5*sm/seq)", "damage", {{"D", 0.1}});
  element.step_to(Tensor<2>::Identity());
  EXPECT_TRUE(element.find().empty());
  double e = 0;
  while (element.events.number("damage") == 0 && e < 0.5) element.go_to(stretch(e += 0.01));
  const double plastic_strain_eq = element.plastic_strain_eq();
  const double D = 0.1 * std::exp(-1.5 * mean<2>(element.stress()) / stress_eq_field(element.body)[0]);
  EXPECT_GE(plastic_strain_eq, D);
  EXPECT_LT(plastic_strain_eq, D + 0.01);
}

TEST(PointEvents, Errors) {
  Element element;
  element.add("ep - 1", "damage");
  expect_invalid([&] { element.add("ep - ", "bad"); }, "event \"bad\" \"ep - \": the formula ends too early");
  expect_invalid([&] { element.add("ep - D", "bad"); }, "\"ep - D\": at character 6: unknown name \"D\"");
  expect_invalid([&] { element.add("ep - D", "bad"); },
                 "expected one of ep, pi, s1, s3, seq, sm, sxx, sxy, syy, szz, x, y");
  expect_invalid([&] { element.add("ep", "bad", {{"sm", 1.}}); }, "name \"sm\" occurs twice");
  expect_invalid([&] { element.add("log(ep)", "bad"); }, "event \"bad\" \"log(ep)\"");
  expect_invalid([&] { element.add("ep", "damage"); }, "PointEvents: name \"damage\" is taken");
  for (const char* name : {"", "a,b", "a\"b", "a\nb"})
    expect_invalid([&] { element.add("ep", name); }, "expected a text without comma, quote and line break");
  expect_invalid([&] { element.events.number("healing"); },
                 "PointEvents: no event \"healing\", expected one of damage");
  expect_invalid([&] { element.events.set_overshoot(-1); }, "overshoot = -1, expected >= 0");
  element.add("1/(sxx - 1e6) - 5", "pole");
  element.step_to(stretch(0.1));
  EXPECT_NO_THROW(element.find()) << "a pole between the places where the formula is evaluated";
  element.body.revert();
  element.add("log(1 + 2*x - 2*X0) - 1", "late", {{"X0", 2. / 3}});
  element.step_to(tensor(0.1, 0, 0, 1));
  expect_invalid([&] { element.find(); }, "event \"late\" \"log(1 + 2*x - 2*X0) - 1\"");
  expect_invalid([&] { element.find(); }, "x = 0.");
}

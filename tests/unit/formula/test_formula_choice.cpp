// min, max and if in formulas: values, derivatives against differences, kinks, what is refused.
#include "contact/formula_friction.hpp"
#include "formula/formula.hpp"
#include <cmath>
#include <gtest/gtest.h>

using namespace burnish;

namespace {

const FormulaNames NAMES{{"x", "y"}, {{"k", 0}, {"n", 3}}};

Formula chosen(const std::string& text) { return Formula("test", text, NAMES); }
double chosen_value(const std::string& text, double x, double y = 0) {
  const double values[] = {x, y};
  return chosen(text)(values);
}
double slope(const std::string& text, double x, double y = 0) {
  const double values[] = {x, y};
  return chosen(text).derivative(0)(values);
}
std::string choice_refused(const std::string& text, double x = 1) {
  try {
    chosen_value(text, x);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}
#define SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << "  got: " << (text)

} // namespace

TEST(FormulaChoice, ValuesAreExact) {
  EXPECT_EQ(chosen_value("min(x, y)", 0.1, 0.3), 0.1);
  EXPECT_EQ(chosen_value("max(x, y)", 0.1, 0.3), 0.3);
  EXPECT_EQ(chosen_value("min(1e-3, x)", 1e200), 1e-3);
  EXPECT_EQ(chosen_value("max(min(x, 2), -2)", -7), -2);
  EXPECT_EQ(chosen_value("min(n, 2) + max(pi, 3)*0", 0), 2);
  EXPECT_EQ(chosen_value("sign(x) + 10*sign(-x)", 0.5), -9);
  for (const double c : {-1., 0., 1e-300, 2.})
    EXPECT_EQ(chosen_value("if(x, 5, y)", c, 7), c > 0 ? 5 : 7) << c;
  for (const double x : {0.2, 0.3, 0.4}) {
    EXPECT_EQ(chosen_value("if(x > 0.3, 1, 2)", x), x > 0.3 ? 1 : 2) << x;
    EXPECT_EQ(chosen_value("if(x < 0.3, 1, 2)", x), x < 0.3 ? 1 : 2) << x;
    EXPECT_EQ(chosen_value("if(x >= 0.3, 1, 2)", x), x >= 0.3 ? 1 : 2) << x;
    EXPECT_EQ(chosen_value("if(x <= 0.3, 1, 2)", x), x <= 0.3 ? 1 : 2) << x;
    EXPECT_EQ(chosen_value("if(-x > -0.3, if(x>=0.2, 1, 2), 3)", x), x < 0.3 ? 1 : 3) << x;
  }
  EXPECT_EQ(chosen_value("if(n > 2, x, y)", 4, 5), 4);
  EXPECT_EQ(chosen_value("if (pi > 3.2, x, y)", 4, 5), 5);
}

TEST(FormulaChoice, WhatIsNotTakenNeedsNoValue) {
  EXPECT_EQ(chosen_value("if(x > 0, log(x), 0)", -1), 0);
  EXPECT_EQ(chosen_value("if(x > 0, log(x), 0)", 1), 0);
  EXPECT_EQ(chosen_value("if(x, 1/x, y)^0.5", 0, 4), 2);
  EXPECT_EQ(chosen_value("if(k, x/k, y)", 1, 4), 4); // a parameter that is 0
  EXPECT_EQ(slope("if(x > 0, sqrt(x), 2*x)", 0), 2);
  SAYS(choice_refused("if(x > 0, log(x), 1/(x+1))", -1),
       "\"if(x > 0, log(x), 1/(x+1))\": 1/0 is no finite real number, at x = -1");
  SAYS(choice_refused("if(log(x) > 0, 1, 2)", -1), "log(-1) is no finite real number");
  SAYS(choice_refused("2*min(3, 1 + log(x))", -1), "log(-1) is no finite real number");
  SAYS(choice_refused("step(log(x))", -1), "log(-1) is no finite real number");
  SAYS(choice_refused("(1 + x)^log(x)", 0), "log(0) is no finite real number");
}

TEST(FormulaChoice, DerivativesAreThoseOfDifferences) {
  const std::vector<std::string> texts{"min(x^2, 1 + x*y)",
                                       "max(sin(3*x), y)*min(x, 2*y)",
                                       "if(x*y > 1, x^2*y, exp(x) - y^3)",
                                       "if(x <= y, min(x, 0.5)*y^2, max(x, y^2))",
                                       "max(abs(x - 1), sign(y)*x^2/4)",
                                       "min(193 + 100*x, 250*y)/(1 + max(0, x - y))"};
  const double h = 1e-5;
  for (const std::string& text : texts) {
    const Formula f = chosen(text);
    for (double x = -1.931; x < 2; x += 0.37)
      for (double y = -1.713; y < 2; y += 0.41) {
        const auto at = [&](const Formula& g, double dx, double dy) {
          const double values[] = {x + dx, y + dy};
          return g(values);
        };
        const Formula fx = f.derivative(0), fy = f.derivative(1);
        EXPECT_NEAR(at(fx, 0, 0), (at(f, h, 0) - at(f, -h, 0)) / (2 * h), 1e-6)
            << text << " " << x << " " << y;
        EXPECT_NEAR(at(fy, 0, 0), (at(f, 0, h) - at(f, 0, -h)) / (2 * h), 1e-6)
            << text << " " << x << " " << y;
        EXPECT_NEAR(at(fx.derivative(1), 0, 0), (at(fx, 0, h) - at(fx, 0, -h)) / (2 * h), 1e-6) << text;
        EXPECT_NEAR(at(fx.derivative(0), 0, 0), (at(fx, h, 0) - at(fx, -h, 0)) / (2 * h), 1e-6) << text;
      }
  }
}

TEST(FormulaChoice, AtAKinkTheSlopeIsThatOfTheGrowingVariable) {
  EXPECT_EQ(slope("min(2*x, 5*x)", 0), 2);
  EXPECT_EQ(slope("min(5*x, 2*x)", 0), 2);
  EXPECT_EQ(slope("max(2*x, 5*x)", 0), 5);
  EXPECT_EQ(slope("max(x, -x)", 0), 1);
  EXPECT_EQ(slope("min(193 + 1000*x, 203)", 0.01), 0); // the plateau begins
  const double at[] = {1, 1};
  EXPECT_EQ(chosen("max(x, y)").derivative(1)(at), 1); // by y, of which it grows, too
  EXPECT_EQ(slope("if(x > 1, 7*x, 3*x)", 1), 3);       // the branch that is taken
  EXPECT_EQ(slope("if(x >= 1, 7*x, 3*x)", 1), 7);
  EXPECT_EQ(slope("min(x, y)^2", 1, 2), 2);
}

TEST(FormulaChoice, AJumpDependsOnItsCondition) {
  EXPECT_TRUE(chosen("if(x > 1, 2, 3)").depends_on(0));
  EXPECT_FALSE(chosen("if(x > 1, 2, 3)").depends_on(1));
  EXPECT_FALSE(chosen("if(x > 1, y, y)").depends_on(0));
  EXPECT_TRUE(chosen("step(x)").depends_on(0));
  EXPECT_TRUE(chosen("sign(x - y)").depends_on(1));
  EXPECT_FALSE(chosen("if(k > 1, x, y)").depends_on(0));
  // a law without friction up to a pressure is none without friction
  EXPECT_FALSE(FormulaFriction("if(p > 2, 3, 0)").vanishes());
  EXPECT_FALSE(FormulaFriction("5*step(p - 2)").vanishes());
  EXPECT_TRUE(FormulaFriction("max(0, 0*p)").vanishes());
}

TEST(FormulaChoice, WrongCallsNameThePlace) {
  SAYS(choice_refused("1+min(x)"), "at character 3: function \"min\" has 1 argument, expected 2");
  SAYS(choice_refused("max(x, y, 1)"), "at character 1: function \"max\" has 3 arguments, expected 2");
  SAYS(choice_refused("if(x, 1)"), "at character 1: function \"if\" has 2 arguments, expected 3");
  SAYS(choice_refused("if(x > 1, 2, 3, 4)"), "at character 1: function \"if\" has 4 arguments, expected 3");
  SAYS(choice_refused("if(x > 1)"), "at character 1: function \"if\" has 1 argument, expected 3");
  SAYS(choice_refused("atan2(x)"), "function \"atan2\" has 1 argument, expected 2");
  SAYS(choice_refused("if"), "function \"if\" needs its argument in parentheses");
  SAYS(choice_refused("x > 1"), "at character 3: \">\" compares only as the first argument of if");
  SAYS(choice_refused("if(x, y < 1, 2)"), "at character 9: \"<\" compares only as the first argument of if");
  SAYS(choice_refused("if((x >= 1), 1, 2)"),
       "at character 7: \">=\" compares only as the first argument of if");
  SAYS(choice_refused("min(x > 1, 2)"), "at character 7: \">\" compares only as the first argument of if");
  SAYS(choice_refused("if(0 < x < 1, 1, 2)"), "at character 10: \"<\" is the second comparison");
  SAYS(choice_refused("if(x == 1, 1, 2)"), "at character 6: \"=\" means nothing");
  SAYS(choice_refused("if(x >, 1, 2)"), "at character 7: unexpected token");
  SAYS(choice_refused("if(x > 1, 1, 2"), "a \")\" is missing");
  SAYS(choice_refused("minimum(x, y)"), "unknown function \"minimum\", expected one of abs, acos");
  SAYS(choice_refused("if_greater(x, y, 1, 2)"), "unknown function \"if_greater\"");
  SAYS(choice_refused("csgn(x)"), "unknown function \"csgn\"");
}

TEST(FormulaChoice, LongChainsAreBounded) {
  std::string deep = "x";
  for (int i = 0; i < 90; ++i) deep = "min(" + deep + ", " + std::to_string(i + 2) + "*y+x^2)";
  EXPECT_EQ(chosen_value(deep, 0.5, 1), 0.5);
  try {
    chosen(deep).derivative(0).derivative(1);
    FAIL() << "a second derivative of more than a million numbers";
  } catch (const std::invalid_argument& error) {
    SAYS(std::string(error.what()), "the formula is too long to be differentiated");
  }
}

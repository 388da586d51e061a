#include "formula/formula.hpp"
#include "formula/formula_scan.hpp"
#include "formula/formula_tape.hpp"
#include <cmath>
#include <gtest/gtest.h>

using namespace burnish;

namespace {

const FormulaNames TWO{{"x", "y"}, {{"e", 0.01}, {"l", 0.05}, {"n", 3}, {"nothing", 0}}};

double value(const std::string& text, double x, double y = 0) {
  const double values[] = {x, y};
  return Formula("test", text, TWO)(values);
}

/// Message of the error that the action throws, "" without one.
template <class Action> std::string message(Action action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}
std::string refused(const std::string& text, const FormulaNames& names = TWO) {
  return message([&] { Formula("x of tool \"crank\"", text, names); });
}
#define HAS(text, part) EXPECT_NE((text).find(part), std::string::npos) << "  got: " << (text)

} // namespace

TEST(Formula, ValuesAndPrecedence) {
  const double x = 0.7, y = 1.3, pi = std::acos(-1.);
  EXPECT_DOUBLE_EQ(value("x-y-1", x, y), x - y - 1);
  EXPECT_DOUBLE_EQ(value("x/y/3", x, y), x / y / 3);
  EXPECT_DOUBLE_EQ(value("-x^2 + 2*(-y)", x, y), -x * x - 2 * y);
  EXPECT_DOUBLE_EQ(value("2^(-x)*y", x, y), std::pow(2, -x) * y);
  EXPECT_DOUBLE_EQ(value("1/2*x", x), 0.5 * x);
  EXPECT_DOUBLE_EQ(value("1e-3*x + .5 + 2.", x), 1e-3 * x + 2.5);
  EXPECT_DOUBLE_EQ(value("pi*x + Pi", x), pi * (x + 1));
  EXPECT_DOUBLE_EQ(value("pow(x, 2) + sqrt(y)", x, y), x * x + std::sqrt(y));
  EXPECT_DOUBLE_EQ(value("x^n", x), x * x * x);
  EXPECT_DOUBLE_EQ(value("step(x) + 10*step(-x) + 100*sign(-y)", x, y), 1 - 100);
  EXPECT_DOUBLE_EQ(value("12", x), 12);
  EXPECT_DOUBLE_EQ(value("e*cos(x)\n +sqrt(l^2-e^2*sin(x)^2)", x),
                   0.01 * std::cos(x) + std::sqrt(2.5e-3 - 1e-4 * std::sin(x) * std::sin(x)));
}

TEST(Formula, PlainNamesWork) { // several of them are functions or constants of GiNaC or of its literature
  const std::vector<std::string> names{"e",     "E",      "r",        "l",   "beta", "gamma", "psi", "zeta",
                                       "eta",   "S",      "H",        "G",   "Li",   "Li2",   "D",   "phi",
                                       "theta", "lambda", "binomial", "q_1", "tau",  "i",     "j",   "i1"};
  for (const std::string& name : names) {
    const double v = 1.5;
    EXPECT_DOUBLE_EQ(Formula("t", "2*" + name + "^2*(1+" + name + ")", {{name}, {}})(&v),
                     2 * v * v * (1 + v));
    EXPECT_DOUBLE_EQ(Formula("t", "2*" + name, {{}, {{name, v}}})(nullptr), 3.0) << name;
  }
}

TEST(Formula, DerivativesAreExact) {
  const double v[] = {0.7, 1.3};
  const Formula f("t", "x^3*sin(y) + exp(x*y)", TWO);
  EXPECT_NEAR(f.derivative(0)(v), 3 * v[0] * v[0] * std::sin(v[1]) + v[1] * std::exp(v[0] * v[1]),
              1e-15 * 10);
  EXPECT_NEAR(f.derivative(0).derivative(1)(v),
              3 * v[0] * v[0] * std::cos(v[1]) + (1 + v[0] * v[1]) * std::exp(v[0] * v[1]), 1e-15 * 10);
  EXPECT_EQ(f.derivative(0).text(), f.text());
  const Formula flat("t", "step(x) + sign(x)*x + abs(y)", TWO); // a step's derivative counts as zero
  EXPECT_DOUBLE_EQ(flat.derivative(0)(v), 1);
  EXPECT_DOUBLE_EQ(flat.derivative(1)(v), 1);
  EXPECT_DOUBLE_EQ(flat.derivative(1).derivative(1)(v), 0);
  const Formula turned("t", "abs(-3*sign(y))/x", TWO); // GiNaC's own derivative by y is 3/(2 x)
  EXPECT_DOUBLE_EQ(turned.derivative(0)(v), -3 / (0.7 * 0.7));
  EXPECT_EQ(turned.derivative(1)(v), 0);
  EXPECT_EQ(turned.derivative(1).derivative(0)(v), 0);
}

TEST(Formula, DependsOn) {
  EXPECT_TRUE(Formula("t", "x*y", TWO).depends_on(1));
  EXPECT_FALSE(Formula("t", "x+e", TWO).depends_on(1));
  EXPECT_FALSE(Formula("t", "(x+y)^2-x^2-y^2-2*x*y", TWO).depends_on(0));
  EXPECT_FALSE(Formula("t", "nothing*cos(x)", TWO).depends_on(0));
}

TEST(Formula, TapeAgreesWithGinac) {
  const std::vector<std::string> texts{"e*cos(x)+sqrt(l^2-e^2*sin(x)^2)",
                                       "atan2(y,x)-asin(x/4)*acos(y/4)+atan(x*y)",
                                       "sinh(x)/cosh(y)+tanh(x-y)+asinh(x)+acosh(1+y)+atanh(x/4)",
                                       "exp(-x^2)*log(1+y^2)^3-abs(x-y)^(1/3)+2^x",
                                       "tan(x/2)*step(x-1)+x^(-2)+y^2.5+pi/(1+x)",
                                       "sign(x-1)*x^n/sqrt(y)"};
  GiNaC::realsymbol x("x"), y("y");
  const GiNaC::symtab table{{"x", x}, {"y", y}, {"e", 0.01}, {"l", 0.05}, {"n", 3}, {"pi", GiNaC::Pi}};
  for (const std::string& text : texts) {
    const GiNaC::ex f = parse_formula(text, table);
    for (const GiNaC::ex& e : {f, f.diff(y)}) {
      const FormulaTape tape(e, {x, y});
      for (double a = 0.3; a < 3; a += 0.61)
        for (double b = 0.4; b < 3; b += 0.57) {
          const double v[] = {a, b};
          const GiNaC::ex exact = e.subs(GiNaC::lst{x == GiNaC::numeric(a), y == GiNaC::numeric(b)}).evalf();
          const double expected = GiNaC::ex_to<GiNaC::numeric>(exact).to_double();
          EXPECT_NEAR(tape(v), expected, 1e-14 * (1 + std::abs(expected))) << e << " at " << a << ", " << b;
        }
    }
  }
}

TEST(Formula, EveryRunGivesTheSameBits) { // GiNaC's order depends on how many symbols were made before
  const double v[] = {0.123, 0.789};
  const auto bits = [&] {
    const Formula f("t", "(0.1*x+0.7*y-0.3*x*y+sin(x)-0.9)^3/(y-x+e*x^2)+sqrt(2)*pi*x-exp(y)", TWO);
    return std::array<double, 3>{f(v), f.derivative(0)(v), f.derivative(1).derivative(0)(v)};
  };
  const auto first = bits();
  for (int i = 0; i < 50; ++i) {
    const GiNaC::realsymbol another;
    EXPECT_EQ(bits(), first);
  }
}

TEST(Formula, SingularPlaces) {
  const auto at = [](const std::string& text, double x) { return message([&] { value(text, x, 2); }); };
  EXPECT_EQ(at("1/x", 0), "test \"1/x\": 1/0 is no finite real number, at x = 0, y = 2");
  HAS(at("log(x)", 0), "\"log(x)\": log(0) is no finite real number, at x = 0, y = 2");
  HAS(at("log(x)", -1), "log(-1) is no finite real number, at x = -1, y = 2");
  HAS(at("sqrt(x-1)", 0), "sqrt(-1) is no finite real number");
  HAS(at("x^x", 0), "(0)^(0) is no finite real number");
  HAS(at("atan(1/x)", 0), "1/0 is no finite real number"); // the arc tangent itself would be finite
  HAS(at("exp(-1/x^2)", 0), "(0)^(-2) is no finite real number");
  HAS(at("asin(x)", 2), "asin(2) is no finite real number");
  HAS(at("exp(x)", 1000), "exp(1000) is no finite real number");
  HAS(at("exp(exp(x))", 1000), "exp(1000) is no finite real number");
  HAS(at("1e300*x*y", 1e10), " * ");
  HAS(at("x", NAN), "the value nan is no finite real number, at x = nan");
  const double zero[] = {0, 0};
  HAS(message([&] { Formula("t", "0^x", TWO).derivative(0); }), "\"0^x\", derivative by x: division by zero");
  HAS(message([&] { Formula("t", "sqrt(x)", TWO).derivative(0)(zero); }),
      "t \"sqrt(x)\", derivative by x: (0)^(-0.5) is no finite real number, at x = 0");
  EXPECT_DOUBLE_EQ(value("sin(x)", 0), 0);
}

TEST(Formula, PowersOfAConstantHaveTheirSlopeAtZero) { // not by the logarithm of the base
  const double zero[] = {0, 0}, negative[] = {-1, 0}, two[] = {2, 0};
  for (const char* text : {"x^pi", "x^(2*sqrt(2))", "x^(3*asinh(3))"}) {
    const Formula first = Formula("f", text, TWO).derivative(0);
    EXPECT_EQ(first(zero), 0) << text;
    EXPECT_EQ(first.derivative(0)(zero), 0) << text;
  }
  EXPECT_EQ(Formula("f", "max(0, x)^pi", TWO).derivative(0)(negative), 0);
  EXPECT_NEAR(Formula("f", "x^pi", TWO).derivative(0)(two), M_PI * std::pow(2, M_PI - 1), 1e-14);
}

TEST(Formula, WrongSyntaxNamesThePlace) {
  EXPECT_EQ(refused("e*cos(x)+"), "x of tool \"crank\" \"e*cos(x)+\": the formula ends too early");
  HAS(refused(""), "\"\": the formula is empty");
  HAS(refused("e*cos(x"), "a \")\" is missing");
  HAS(refused("x)*y"), "at character 2: expected the end, got: \")\"");
  HAS(refused("x*(y+)"), "at character 6: unexpected token, got: \")\"");
  HAS(refused("2x"), "at character 2: an operator is missing before \"x\"");
  HAS(refused("x y"), "at character 3: an operator is missing before \"y\"");
  HAS(refused("(x)(y)"), "at character 4: an operator is missing before \"(\"");
  HAS(refused("x*-y+1"), "at character 3: a sign after an operator needs parentheses");
  HAS(refused("x**2"), "at character 3: unexpected token, got: \"*\"");
  HAS(refused("x^y^2"), "a^b^c is ambiguous");
  HAS(refused("x//2"), "at character 3: unexpected token");
  HAS(refused("x # y"), "at character 3: \"#\" means nothing");
  HAS(refused("x+\xce\xb2"), "at character 3: \"\xce\xb2\" means nothing"); // one character of two bytes
  HAS(refused("x+\x01"), "at character 3: the control character 1 means nothing");
  HAS(refused(std::string("x+\0y", 4)), "\"x+?y\": at character 3: the control character 0 means nothing");
  HAS(refused("{x}"), "at character 1: \"{\" means nothing");
  HAS(refused("x==y"), "at character 2: \"=\" means nothing");
  HAS(refused("1..2"), "at character 3: an operator is missing before \".2\"");
  HAS(refused("sin()"), "at character 1: function \"sin\" has no argument");
  HAS(refused("1+sin(x,y)"), "at character 3: function \"sin\" has 2 arguments, expected 1");
  HAS(refused("sin x"), "at character 1: function \"sin\" needs its argument in parentheses");
  HAS(refused("x(1+y)"), "at character 1: \"x\" is no function; a product needs *");
}

TEST(Formula, UnknownNamesListTheKnownOnes) {
  HAS(refused("e*cos(z)"), "at character 7: unknown name \"z\", expected one of e, l, n, nothing, pi, x, y");
  HAS(refused("cosine(x)"), "at character 1: unknown function \"cosine\", expected one of abs, acos, ");
  HAS(refused("1+tgamma(x)"), "at character 3: unknown function \"tgamma\"");
  HAS(refused("I*I*x"), "unknown name \"I\"");
  HAS(refused("psi(1+x)", {{"x", "psi"}, {}}), "\"psi\" is no function");
}

TEST(Formula, ConstantPartsAreChecked) {
  HAS(refused("x/0"), "\"x/0\": division by zero");
  HAS(refused("x/nothing"), "division by zero");
  HAS(refused("x+log(0)"), "log(0)");
  HAS(refused("x*sqrt(-2)"), "no finite real number");
  HAS(refused("x*acos(2)"), "its part acos(2) is no finite real number");
  HAS(refused("x+1e400"), "at character 3: the number is too large");
  HAS(refused("x+1e-4000"), "at character 3: the number is too small");
  HAS(refused("1e-310*x"), "at character 1: the number is too small");
  HAS(refused("x+1e-99999999999999999999"), "at character 3: the number is too small");
  HAS(refused("x+10^400"), "its part 1.0E400 is no finite real number");
  HAS(refused("x*1e-300*1e-300"), "its part 1.0E-600 is no finite real number in the range of double");
  HAS(refused("sqrt(-1)*sqrt(-1)*x"), "its part sqrt(-1) is no finite real number"); // the product is real
  HAS(refused("log(-1)*x"), "its part log(-1) is no finite real number");
  EXPECT_DOUBLE_EQ(value("x+0e99999999999999999999+0^pi", 2), 2);
}

TEST(Formula, LargePowersAreNotComputed) { // GiNaC would be busy for minutes, or end the process
  HAS(refused("x+10^(10^8)"), "its part (10)^(100000000) is too large to be computed exactly");
  HAS(refused("2^1000000000"), "too large to be computed exactly");
  HAS(refused("x*7^123456789.5"), "too large to be computed exactly");
  HAS(refused("(2*x)^1000000000"), "too large to be computed exactly");
  HAS(refused("(2+4*x)^1000000000"), "too large to be computed exactly");
  HAS(refused("n^(l*1e12)"), "its part (3)^(50000000000) is too large");
  HAS(refused("1.0000001^(10^6)"), "too large to be computed exactly");
  EXPECT_DOUBLE_EQ(value("x^1000000", 1), 1);
  EXPECT_DOUBLE_EQ(value("2^500*x", 1), std::pow(2, 500));
  EXPECT_TRUE(Formula("t", "(x+y+1)^1000", TWO).depends_on(0)); // half a million terms, were it expanded
  EXPECT_TRUE(Formula("t", "((x+1)^20+y)^20", TWO).depends_on(1));
  EXPECT_TRUE(Formula("t", "x^6200000000", TWO).depends_on(0));
}

namespace {
std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}
} // namespace

TEST(Formula, LongTextsAreRefusedOrWork) {
  for (const char* part : {"a", "1", "x+", "(", "sin(", "0.", "x^(", "-(-"}) {
    const std::string why = refused(repeated(part, 100000));
    HAS(why, " characters, expected at most 10000");
    EXPECT_LT(why.size(), 400u) << part; // quotes its beginning only
  }
  HAS(refused(repeated("a", 9000)), "at character 1: unknown name \"aaa");
  HAS(refused(repeated("1", 9000)), "at character 1: the number is too large");
  HAS(refused(repeated("(", 200) + "x" + repeated(")", 200)), "at character 101: more than 100 parentheses");
  EXPECT_DOUBLE_EQ(value("0." + repeated("3", 9000) + "*x", 3), 1);
  EXPECT_DOUBLE_EQ(value(repeated("(", 100) + "x" + repeated(")", 100), 3), 3);
  EXPECT_DOUBLE_EQ(value(repeated("x+", 4999) + "x", 3), 15000);
  std::string product = "x";
  for (int i = 0; i < 300; ++i) product += "*sin(" + std::to_string(i) + ".5*x)";
  const Formula many("t", product,
                     TWO); // a derivative of 300 terms with 300 factors: the second one is too long
  HAS(message([&] { many.derivative(0).derivative(0); }), "the formula is too long to be differentiated");
}

TEST(Formula, NamesAreChecked) {
  for (const char* name : {"I", "Pi", "pi", "Euler", "Catalan"})
    HAS(refused("x", {{"x", name}, {}}), "name \"" + std::string(name) + "\" is taken by a constant");
  for (const char* name : {"sin", "sqrt", "pow", "atan2", "abs", "min", "max", "if", "sign"})
    HAS(refused("x", {{"x"}, {{name, 1}}}), "name \"" + std::string(name) + "\" is taken by a function");
  for (const char* name : {"", "1x", "a b", "x-y", "_a"})
    HAS(refused("x", {{"x", name}, {}}), "name \"" + std::string(name) + "\" is no identifier");
  HAS(refused("x", {{"x", "x"}, {}}), "name \"x\" occurs twice");
  HAS(refused("x", {{"x"}, {{"x", 1}}}), "name \"x\" occurs twice");
  HAS(refused("x", {{"x"}, {{"a", INFINITY}}}), "parameter \"a\" = inf, expected a finite number");
  HAS(message([] { Formula("t", "x", TWO).derivative(2); }), "variable = 2, expected 0 to 1");
}

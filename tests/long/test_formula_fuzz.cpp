// Formulas made at random: values, first and second derivatives against an independent reading of the text,
// and texts spoiled at random, which must give a number or an error that quotes them. Seeds are fixed.
#include "formula/formula.hpp"
#include "long/formula_reference.hpp"
#include <array>
#include <chrono>
#include <gtest/gtest.h>
#include <random>

using namespace burnish;

namespace {

using Random = std::mt19937;
int below(Random& random, int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); }
template <class List> const auto& any(Random& random, const List& list) {
  return list[static_cast<std::size_t>(below(random, static_cast<int>(list.size())))];
}

const std::vector<std::string> ONE{"sin",   "cos",   "tan",   "asin", "acos", "atan", "sinh", "cosh", "tanh",
                                   "asinh", "acosh", "atanh", "exp",  "log",  "sqrt", "abs",  "step", "sign"};
const std::vector<std::string> LEAVES{"x",    "y",    "x",  "y",  "2",  "3", "0.5",
                                      "1.25", "1e-1", ".7", "3.", "pi", "0", "1"};

std::string blank(Random& random) {
  return below(random, 6) ? "" : any(random, std::vector<std::string>{" ", "\n", "  "});
}

/// Text of a formula with at most `depth` levels.
std::string text_of(Random& random, int depth) {
  if (depth == 0 || below(random, 8) == 0) return any(random, LEAVES);
  const auto part = [&] { return blank(random) + text_of(random, depth - 1) + blank(random); };
  switch (below(random, 11)) {
  case 0:
    return part() + "+" + part();
  case 1:
    return part() + "-" + part();
  case 2:
    return part() + "*" + part();
  case 3:
    return part() + "/" + part();
  case 4:
    return "(" + part() + ")^" + (below(random, 2) ? "2" : "(" + part() + ")");
  case 5:
    return "(" + std::string(below(random, 3) ? "" : "-") + part() + ")";
  case 6:
    return "(" + part() + ")*(" + part() + ")";
  case 7:
    return (below(random, 2) ? "atan2(" : "pow(") + part() + "," + part() + ")";
  case 8:
    return (below(random, 2) ? "min(" : "max(") + part() + "," + part() + ")";
  case 9:
    return "if(" + part() + any(random, std::vector<std::string>{"", ">0.3", "<x", ">=y", "<=2"}) + "," +
           part() + "," + part() + ")";
  default:
    return any(random, ONE) + "(" + part() + ")";
  }
}

std::string why(const std::exception& error) { return error.what(); }

struct Count {
  int compared = 0, refused = 0, outside = 0;
};

/// Compares value and derivatives at one place; false if something is wrong.
void compare(const std::string& text, double x, double y, Count& count) {
  reference::Jet expected;
  try {
    expected = reference::Parser(text, x, y).result();
  } catch (const std::runtime_error&) {
    ++count.outside; // wrong syntax, or what the reference does not know
    return;
  }
  if (!expected.finite() || expected.largest > 1e8L) {
    ++count.outside;
    return;
  }
  const double v[] = {x, y};
  try {
    const Formula f("f", text, {{"x", "y"}, {}}), fx = f.derivative(0), fy = f.derivative(1);
    const std::array<double, 6> got{
        f(v), fx(v), fy(v), fx.derivative(0)(v), fx.derivative(1)(v), fy.derivative(1)(v)};
    const std::array<reference::Real, 6> want{expected.f,  expected.x,  expected.y,
                                              expected.xx, expected.xy, expected.yy};
    const double scale = static_cast<double>(1 + expected.largest * expected.largest);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(got[i], static_cast<double>(want[i]), 1e-11 * scale)
          << "number " << i << " of " << text << " at " << x << ", " << y;
    ++count.compared;
  } catch (const std::invalid_argument& error) {
    ++count.refused;
    EXPECT_EQ(why(error).compare(0, 3, "f \""), 0) << why(error);
    const bool allowed = why(error).find("too") != std::string::npos ||
                         why(error).find("in the range of double") != std::string::npos ||
                         why(error).find("undefined") != std::string::npos || // long, large, small
                         why(error).find("sign after an operator") != std::string::npos ||
                         why(error).find("ambiguous") != std::string::npos;
    EXPECT_TRUE(allowed) << why(error) << "\n at " << x << ", " << y << " is "
                         << static_cast<double>(expected.f);
  }
}

std::string spoiled(Random& random, std::string text) {
  static const std::vector<std::string> scraps{
      "(",   ")",    "+", "-",   "*",  "/",       "^",        ",",  ".",    "e",    "x",     "y",
      "sin", "1",    "0", "1e9", " ",  "\n",      "\xce\xb2", "#",  "\"",   "\\",   "1e",    "pi",
      "if(", "min(", ">", "<=",  "x(", "9999999", "^(-1)",    "/0", "((((", "))))", "sqrt(", "0^"};
  for (int i = 1 + below(random, 4); i > 0; --i) {
    const auto at = static_cast<std::size_t>(below(random, static_cast<int>(text.size()) + 1));
    switch (below(random, 5)) {
    case 0:
      text.erase(at, static_cast<std::size_t>(1 + below(random, 3)));
      break;
    case 1:
      text.insert(at, 1, static_cast<char>(below(random, 256)));
      break;
    case 2:
      text.insert(at, text.substr(at / 2, static_cast<std::size_t>(below(random, 12))));
      break;
    default:
      text.insert(at, any(random, scraps));
    }
  }
  return text;
}

} // namespace

TEST(FormulaFuzz, ValuesAndDerivativesAreThoseOfTheText) {
  Random random(20070);
  std::uniform_real_distribution<double> place(-2, 2);
  Count count;
  for (int i = 0; i < 30000 && !::testing::Test::HasFailure(); ++i)
    compare(text_of(random, 1 + i % 5), place(random), place(random), count);
  EXPECT_GT(count.compared, 10000);
  EXPECT_LT(count.refused, 100);
  RecordProperty("compared", count.compared);
  std::cout << count.compared << " compared, " << count.refused << " refused, " << count.outside
            << " outside\n";
}

TEST(FormulaFuzz, SpoiledTextsGiveTheirValueOrAnError) {
  Random random(20071);
  std::uniform_real_distribution<double> place(-2, 2);
  Count count;
  double slowest = 0;
  int good = 0, bad = 0;
  for (int i = 0; i < 40000 && !::testing::Test::HasFailure(); ++i) {
    const std::string text = spoiled(random, text_of(random, 1 + i % 4));
    const double v[] = {place(random), place(random)};
    const auto begin = std::chrono::steady_clock::now();
    try {
      const Formula f("f", text, {{"x", "y"}, {}});
      f.derivative(0).derivative(1);
      f.depends_on(0);
      EXPECT_TRUE(std::isfinite(f(v))) << text;
      ++good;
    } catch (const std::invalid_argument& error) {
      ++bad;
      EXPECT_EQ(why(error).compare(0, 3, "f \""), 0) << why(error);
      EXPECT_GT(why(error).size(), text.size() + 10) << why(error);
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    slowest = std::max(slowest, took.count());
    EXPECT_LT(took.count(), 5) << text;
    if (text.find('\0') == std::string::npos) compare(text, v[0], v[1], count);
  }
  EXPECT_GT(good, 2000);
  EXPECT_GT(bad, 10000);
  std::cout << good << " with a value, " << bad << " refused, " << count.compared << " compared, slowest "
            << slowest << " s\n";
}

// Numbers and texts of scripts: what counts as a number, and JSON that gives both back.
#include "script/text.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>
#include <limits>

using namespace burnish;
using namespace burnish::test;

TEST(ScriptText, NumbersAreRead) {
  EXPECT_EQ(parse_number("0.3", ""), 0.3);
  EXPECT_EQ(parse_number("-15e-3", ""), -15e-3);
  EXPECT_EQ(parse_number("+2", ""), 2);
  EXPECT_EQ(parse_number(".5", ""), 0.5);
  EXPECT_EQ(parse_number("7.", ""), 7);
  EXPECT_EQ(parse_number("1e308", ""), 1e308);
}

TEST(ScriptText, WhatIsNoNumberIsRefusedInTheCallersWords) {
  for (const char* text :
       {"", "-", "x", "1,5", "1x", "1 2", "3e", "--2", "1e999", "-1e999", "nan", "inf", "-Inf"}) {
    SCOPED_TRACE(text);
    expect_invalid([&] { parse_number(text, "here: a number is wanted"); }, "here: a number is wanted");
  }
}

TEST(ScriptText, JsonNumbersInTheFewestDigitsThatGiveThemBack) {
  EXPECT_EQ(json_number(0.3), "0.3");
  EXPECT_EQ(json_number(-2), "-2");
  EXPECT_EQ(json_number(0), "0");
  EXPECT_EQ(json_number(123456789), "123456789");
  EXPECT_EQ(json_number(15e-3), "0.015");
  EXPECT_EQ(json_number(2.1e11), "2.1e+11");
  EXPECT_EQ(json_number(0.1 + 0.2), "0.30000000000000004");
  for (double value = 1e-300; value < 1e300; value *= -7.3e9) {
    const double odd = std::nextafter(value, 1);
    EXPECT_EQ(parse_number(json_number(odd), "a number"), odd);
  }
}

TEST(ScriptText, JsonKnowsNoInfinity) {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity(), -HUGE_VAL})
    EXPECT_EQ(json_number(value), "null");
}

TEST(ScriptText, JsonTexts) {
  EXPECT_EQ(json_text(""), "\"\"");
  EXPECT_EQ(json_text("out/a b"), "\"out/a b\"");
  EXPECT_EQ(json_text("say \"no\""), "\"say \\\"no\\\"\"");
  EXPECT_EQ(json_text("C:\\dir"), "\"C:\\\\dir\"");
  EXPECT_EQ(json_text("a\nb\tc"), "\"a\\u000ab\\u0009c\"");
  EXPECT_EQ(json_text(std::string("\x1f") + "12"), "\"\\u001f12\"") << "decimal again after the escape";
  EXPECT_EQ(json_text("M\xc3\xbcller"), "\"M\xc3\xbcller\"") << "other letters stay";
}

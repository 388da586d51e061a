// Options of a script: values and defaults, help, JSON, and every word that is refused.
#include "script/options.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

using Words = std::vector<std::string>;

/// Options of "FreeFem++ -nw -v 0 dir/case.edp ...".
ScriptOptions given(const Words& words) {
  Words all{"FreeFem++", "-nw", "-v", "0", "dir/case.edp"};
  all.insert(all.end(), words.begin(), words.end());
  return ScriptOptions(all);
}
double real(const Words& words) { return given(words).real("-R", 2.5, "m", "radius"); }
long integer(const Words& words) { return given(words).integer("-n", 7, "", "steps"); }
std::string text(const Words& words) { return given(words).text("-out", "out", "", "folder"); }

/// The options of a small script, all asked for.
ScriptOptions asked(const Words& words) {
  ScriptOptions options = given(words);
  options.real("-R", 15e-3, "m", "radius of the roller");
  options.integer("-steps", 40, "", "number of steps");
  options.text("-element", "P2", "", "finite element");
  options.text("-out", "", "", "folder of the results");
  return options;
}

} // namespace

TEST(ScriptOptions, ScriptAndFolder) {
  EXPECT_EQ(given({}).script(), "dir/case.edp");
  EXPECT_EQ(given({}).folder(), "dir/");
  EXPECT_EQ(ScriptOptions({"FreeFem++", "case.edp"}).folder(), "./");
  EXPECT_EQ(ScriptOptions({"FreeFem++", "/case.edp"}).folder(), "/");
  EXPECT_EQ(ScriptOptions({"FreeFem++", "/a/b.d/case.edp"}).folder(), "/a/b.d/");
  EXPECT_EQ(ScriptOptions({"x", "a.edp", "-file", "b.edp"}).script(), "a.edp") << "the first one";
  const ScriptOptions none({"FreeFem++", ".edp", "-R", "3"});
  EXPECT_EQ(none.script(), "");
  EXPECT_EQ(none.folder(), "./");
  EXPECT_NO_THROW(none.refuse_unknown()) << "no script, no words of its own";
}

TEST(ScriptOptions, Defaults) {
  EXPECT_EQ(real({}), 2.5);
  EXPECT_EQ(integer({}), 7);
  EXPECT_EQ(text({}), "out");
  ScriptOptions before({"FreeFem++", "-R", "9", "case.edp"});
  EXPECT_EQ(before.real("-R", 2.5, "", ""), 2.5) << "words before the script are not its own";
}

TEST(ScriptOptions, GivenValues) {
  EXPECT_EQ(real({"-R", "15e-3"}), 15e-3);
  EXPECT_EQ(real({"-R", "4"}), 4);
  EXPECT_EQ(integer({"-n", "12"}), 12);
  EXPECT_EQ(integer({"-n", "1e3"}), 1000);
  EXPECT_EQ(text({"-out", "a b/c"}), "a b/c");
  EXPECT_EQ(text({"-out", "12"}), "12");
  EXPECT_EQ(real({"-n", "3", "-R", "4", "-out", "x"}), 4) << "among others";
}

TEST(ScriptOptions, NegativeNumbersAreValues) {
  EXPECT_EQ(real({"-R", "-0.5"}), -0.5);
  EXPECT_EQ(real({"-R", "-1e-3"}), -1e-3);
  EXPECT_EQ(integer({"-n", "-4"}), -4);
  ScriptOptions options = given({"-R", "-0.5", "-n", "-4"});
  options.real("-R", 1, "", "");
  options.integer("-n", 1, "", "");
  EXPECT_NO_THROW(options.refuse_unknown());
}

TEST(ScriptOptions, TheLastOfRepeatedOnesCounts) {
  EXPECT_EQ(real({"-R", "1", "-n", "3", "-R", "2"}), 2);
  EXPECT_EQ(text({"-out", "a", "-out", "b"}), "b");
  ScriptOptions options = given({"-R", "1", "-R", "2"});
  options.real("-R", 3, "m", "first words");
  options.real("-R", 3, "mm", "second words");
  EXPECT_EQ(options.help(), "  -R  2  mm  second words\n") << "asked twice, listed once";
  EXPECT_NO_THROW(options.refuse_unknown());
}

// A word that follows an option is its value, whatever it looks like.
TEST(ScriptOptions, AValueMayLookLikeAnOption) {
  ScriptOptions options = given({"-R", "4", "-out", "-R", "-n", "3"});
  EXPECT_EQ(options.text("-out", "", "", ""), "-R");
  EXPECT_EQ(options.real("-R", 2.5, "", ""), 4);
  EXPECT_EQ(options.integer("-n", 7, "", ""), 3);
  EXPECT_NO_THROW(options.refuse_unknown());
  EXPECT_EQ(real({"-out", "-R"}), 2.5);
  EXPECT_EQ(real({"-R", "1", "-v", "0", "-out", "-nw", "-n", "-R"}), 1);
}

TEST(ScriptOptions, FreeFemsOwnWordsAreLeftToIt) {
  ScriptOptions options = given({"-nw", "-R", "4", "-v", "1", "-wg", "-n", "3", "-gff", "viewer", "-wait"});
  EXPECT_EQ(options.real("-R", 2.5, "", ""), 4);
  EXPECT_EQ(options.integer("-n", 7, "", ""), 3);
  EXPECT_NO_THROW(options.refuse_unknown());
}

TEST(ScriptOptions, HelpIsWantedAnywhere) {
  EXPECT_FALSE(given({"-R", "4"}).wants_help());
  for (const char* word : {"-h", "--help"}) {
    EXPECT_TRUE(given({word}).wants_help());
    ScriptOptions options = given({"-R", "4", word, "-n", "3"});
    EXPECT_TRUE(options.wants_help());
    EXPECT_EQ(options.real("-R", 2.5, "", ""), 4);
    EXPECT_EQ(options.integer("-n", 7, "", ""), 3);
    EXPECT_NO_THROW(options.refuse_unknown());
  }
  EXPECT_FALSE(ScriptOptions({"FreeFem++", "-h", "case.edp"}).wants_help()) << "FreeFEM's";
}

TEST(ScriptOptions, HelpText) {
  EXPECT_EQ(asked({"-steps", "5"}).help(), "  -R        0.015  m  radius of the roller\n"
                                           "  -steps    5         number of steps\n"
                                           "  -element  P2        finite element\n"
                                           "  -out      \"\"        folder of the results\n");
  EXPECT_EQ(given({}).help(), "");
}

TEST(ScriptOptions, Json) {
  EXPECT_EQ(asked({"-R", "2e-3", "-out", "a\"b"}).json(),
            "\"R\": 0.002, \"steps\": 40, \"element\": \"P2\", \"out\": \"a\\\"b\"");
  EXPECT_EQ(given({}).json(), "");
}

TEST(ScriptOptionsErrors, Numbers) {
  expect_invalid([] { real({"-R", "wide"}); }, "option -R has the value \"wide\", expected a number");
  expect_invalid([] { real({"-R", "1,5"}); }, "option -R has the value \"1,5\", expected a number");
  expect_invalid([] { real({"-R", "nan"}); }, "option -R has the value \"nan\", expected a number");
  expect_invalid([] { real({"-R", "-n", "3"}); }, "option -R has the value \"-n\", expected a number");
  expect_invalid([] { integer({"-n", "2.5"}); }, "option -n has the value \"2.5\", expected a whole number");
  expect_invalid([] { integer({"-n", "ten"}); }, "option -n has the value \"ten\", expected a whole number");
  expect_invalid(
      [] {
        integer({"-n", "1e16"});
      },
      "option -n has the value \"1e16\", expected a whole number");
}

TEST(ScriptOptionsErrors, Positive) {
  const auto lengths = [](const std::string& R, const std::string& W) {
    ScriptOptions options = given({"-R", R, "-W", W, "-mu", "1e-12"});
    for (const char* name : {"-R", "-W"}) options.real(name, 1, "mm", "");
    options.real("-mu", 1, "-", "");
    options.positive("-R -W -mu");
  };
  EXPECT_NO_THROW(lengths("12", "40"));
  EXPECT_NO_THROW(lengths("1e8", "1")); // just allowed
  EXPECT_NO_THROW(lengths("1e-15", "1e-15"));
  expect_invalid([&] { lengths("0", "40"); }, "option -R is 0, expected > 0");
  expect_invalid([&] { lengths("1", "1e-300"); }, "option -W is 1e-300, expected > 0, 1e-15 to 1e+15");
  expect_invalid([&] { lengths("1", "2e15"); }, "option -W is 2e+15, expected > 0, 1e-15 to 1e+15");
  expect_invalid([&] { lengths("12", "1e-9"); },
                 "options -R and -W are 12 and 1e-09 mm, expected at most a factor of 1e+08 apart");
}

TEST(ScriptOptionsErrors, NoValue) {
  expect_invalid([] { real({"-R"}); }, "option -R has no value");
  expect_invalid([] { integer({"-R", "3", "-n"}); }, "option -n has no value");
  expect_invalid([] { text({"-out", "a", "-out"}); }, "option -out has no value");
}

TEST(ScriptOptionsErrors, UnknownWords) {
  const std::string list = ", expected one of -R -steps -element -out";
  expect_invalid([] { asked({"-r", "3"}).refuse_unknown(); }, "unknown option -r" + list);
  expect_invalid([] { asked({"-R", "3", "4"}).refuse_unknown(); }, "unknown option 4" + list);
  expect_invalid([] { asked({"--", "-R", "3"}).refuse_unknown(); }, "unknown option --" + list);
  expect_invalid([] { asked({"--R", "3"}).refuse_unknown(); }, "unknown option --R" + list);
  expect_invalid([] { asked({"R=3"}).refuse_unknown(); }, "unknown option R=3" + list);
  EXPECT_NO_THROW(asked({}).refuse_unknown());
}

TEST(ScriptOptionsErrors, NamesThatAreTaken) {
  const std::string taken = ": the name is one of FreeFEM's own or asks for help; choose another, such as -";
  const auto ask = [](const std::string& name) { given({}).real(name, 1, "", ""); };
  for (const char* name : {"-f", "-v", "-nw", "-ng", "-wg", "-ne", "-ns", "-nc", "-cd", "-cdtmp", "-jc",
                           "-log", "-wait", "-nowait", "-glut", "-fglut", "-gff", "-check_plugin", "-?"})
    expect_invalid([&] { ask(name); }, std::string("option ") + name + taken);
  expect_invalid([&] { ask("-h"); }, "option -h" + taken + "hh");
  expect_invalid([&] { ask("--help"); }, "option --help" + taken + "pp");
  expect_invalid([] { given({}).integer("-v", 1, "", ""); }, "option -v" + taken + "vv");
  expect_invalid([] { given({}).text("-f", "a", "", ""); }, "option -f" + taken + "ff");
}

TEST(ScriptOptionsErrors, NamesWithoutADash) {
  for (const char* name : {"R", "", "-"})
    expect_invalid([&] { given({}).real(name, 1, "", ""); },
                   std::string("option: name = \"") + name + "\", expected a dash and a word, such as -R");
}

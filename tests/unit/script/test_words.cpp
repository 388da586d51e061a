// Which names a script uses: comments and the library do not count, included files do.
#include "script/words.hpp"
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

using namespace burnish;

TEST(ScriptWords, CommentsDoNotCountIncludedFilesDo) {
  const std::string folder = ::testing::TempDir() + "words";
  std::filesystem::create_directories(folder + "/library");
  const auto write = [](const std::string& path, const std::string& text) { std::ofstream(path) << text; };
  write(folder + "/library/burnish.idp", "real everything;");
  write(folder + "/library/shared.idp", "real inLibrary; include \"beside.idp\"");
  write(folder + "/beside.idp", "include \"../words/beside.idp\"\nreal beside;");
  const std::string script = folder + "/scene.edp";
  write(
      script,
      "include \"burnish.idp\"\nreal used = 2; // inComment\n/* inBlock */ cout << \"// /* \" << afterText;\n"
      "include \"beside.idp\"\ninclude \"shared.idp\"\nreal usedTwice;");
  const auto uses = [&](const std::string& words) {
    return script_uses(script, words, "nowhere;" + folder + "/library");
  };
  for (const char* word : {"used", "afterText", "beside", "inLibrary", "other used", "usedTwice"})
    EXPECT_TRUE(uses(word)) << word;
  for (const char* word : {"inComment", "inBlock", "everything", "use", "sed", ""})
    EXPECT_FALSE(uses(word)) << word;
  EXPECT_FALSE(script_uses(folder + "/none.edp", "used", ""));
  EXPECT_FALSE(script_uses("", "used", ""));
}

// FreeFEM says "syntax error" of these alone; comments, texts and what stands before the include do not count.
TEST(ScriptWords, DeclaredNamesOfTypes) {
  const std::string script = ::testing::TempDir() + "declared.edp";
  const auto declared = [&](const std::string& code) {
    std::ofstream(script) << "real contact = 1;\n// include\ninclude \"burnish.idp\"\n" << code;
    return declared_name(script, "tool contact material");
  };
  for (const char* code :
       {"real tool = 1;", "int a = 2, tool;", "mesh tool(Th);", "func real[int] tool(real x) { return x; }",
        "real[int] tool(3);", "func int f(real tool) { return 1; }", "/* of\ntwo lines */ string tool;",
        "fespace Vh(Th, P1); Vh tool = x;", "fespace Vh(Th, [P1, P1]);\nVh [u, tool] = [0, 0];",
        "fespace Vh(Th, P1);\nVh<complex> u, tool;", "fespace Vh(Th, [P1, P1]);\nVh [tool, v];"})
    EXPECT_EQ(declared(code).substr(0, 12), "tool in line") << code;
  EXPECT_EQ(declared("/* of\ntwo lines */ string tool;"), "tool in line 5");
  EXPECT_EQ(declared("real h;\nreal contact = h;"), "contact in line 5");
  for (const char* code :
       {"tool roller(circle=1., name=\"roller\");",
        "func int f(contact & C, material & M, tool & t) { return 1; }", "// real tool = 1;",
        "string s = \"real tool = 1;\";", "contact C = rcContact(Vh, label=3);",
        "fespace Vh(Th, P1); Vh u = x; tool t(circle=f(Vh, 2, tool=1));", "real tools = 1;"})
    EXPECT_EQ(declared(code), "") << code;
  EXPECT_EQ(declared_name(script + ".none", "tool"), "");
}

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

#include "base/file_error.hpp"
#include "base/temporary.hpp"
#include "output/summary.hpp"
#include <cmath>
#include <gtest/gtest.h>

using namespace burnish;

namespace {

std::string saved(const Json& summary) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/summary.json";
  save_summary(summary, path);
  return file_content(path);
}

} // namespace

TEST(Summary, LinePerKeyInOrder) {
  const Json summary{{"status", "finished"}, {"final", {{"t", 1.5}, {"contact", 3}}}, {"left_out", ""}};
  EXPECT_EQ(
      saved(summary),
      "{\n  \"status\": \"finished\",\n  \"final\": {\"t\":1.5,\"contact\":3},\n  \"left_out\": \"\"\n}\n");
  EXPECT_EQ(Json::parse(saved(summary)), summary);
}

TEST(Summary, NumbersComeBackAndUndefinedOnesAreNull) {
  const Json back = Json::parse(saved({{"third", 1. / 3}, {"nan", std::nan("")}, {"inf", INFINITY}}));
  EXPECT_EQ(back["third"].get<double>(), 1. / 3);
  EXPECT_TRUE(back["nan"].is_null() && back["inf"].is_null());
}

// Names of files and tools come from the command line.
TEST(Summary, TextsOfAnyBytes) {
  const std::string odd = "a \"quoted\" \\name\n\x01";
  EXPECT_EQ(Json::parse(saved({{odd, odd}}))[odd], odd);
  const Json latin = Json::parse(saved({{"out", "caf\xe9"}}));
  EXPECT_EQ(latin["out"], "caf\xef\xbf\xbd");
}

TEST(Summary, FolderThatIsNotThere) {
  EXPECT_THROW(save_summary({{"t", 1}}, "/nowhere/summary.json"), FileError);
}

TEST(Summary, Versions) {
  const Json all = versions();
  for (const char* name : {"burnish", "eigen", "sparse", "blas", "compiler"})
    EXPECT_TRUE(all.contains(name) && !all[name].get<std::string>().empty()) << name;
}

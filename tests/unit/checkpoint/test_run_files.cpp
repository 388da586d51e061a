// Which checkpoints in a folder are of later runs of the script.
#include "base/temporary.hpp"
#include "checkpoint/run_files.hpp"
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>

using namespace burnish;

TEST(RunFiles, LaterOnesAreThoseOfLargerNumbers) {
  const TemporaryFolder folder;
  for (const char* name : {"run-1.checkpoint", "run-2.checkpoint", "run-2.checkpoint.old",
                           "run-10.checkpoint", "run-3.checkpoint.new", "press.checkpoint", "history.csv"})
    std::ofstream(folder.path() + "/" + name) << "x";
  const auto later = [&](const std::string& path) {
    std::vector<std::string> files = later_run_files(path);
    std::sort(files.begin(), files.end());
    return files;
  };
  const std::string first = run_file(folder.path(), 1), second = run_file(folder.path(), 2);
  EXPECT_EQ(first, folder.path() + "/run-1.checkpoint");
  EXPECT_EQ(later(first), (std::vector<std::string>{run_file(folder.path(), 10), second, second + ".old"}));
  EXPECT_EQ(later(second), std::vector<std::string>{run_file(folder.path(), 10)});
  EXPECT_TRUE(later(run_file(folder.path(), 10)).empty());
  EXPECT_TRUE(later(folder.path() + "/press.checkpoint").empty());
  EXPECT_TRUE(later(folder.path() + "/gone/run-1.checkpoint").empty());
}

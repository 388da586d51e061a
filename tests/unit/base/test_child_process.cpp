#include "base/child_process.hpp"
#include "base/memory_limit.hpp"
#include "base/temporary.hpp"
#include "unit/finite_difference.hpp"
#include <clocale>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <unistd.h>

using namespace burnish;
using namespace burnish::test;

namespace {

ChildEnd run(const std::function<std::string()>& function, std::string* printed = nullptr) {
  const TemporaryFile log("", ".log");
  const ChildEnd end = run_in_child(function, log.path());
  if (printed) *printed = file_content(log.path());
  return end;
}

} // namespace

TEST(ChildProcess, HandsBackWhatTheFunctionReturns) {
  for (const std::string& text : {std::string(), std::string("hello"), std::string(3000000, 'x')}) {
    const ChildEnd end = run([&] { return text; });
    EXPECT_TRUE(end.returned);
    EXPECT_EQ(end.result, text);
    EXPECT_EQ(end.signal, 0);
    EXPECT_FALSE(end.exit);
  }
}

// Neither system nor what it would start; a file that is read may name programs.
TEST(ChildProcess, StartsNoProgram) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/made";
  const ChildEnd end = run([&] { return std::to_string(std::system(("touch " + file).c_str())); });
  EXPECT_TRUE(end.returned);
  EXPECT_NE(end.result, "0");
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(std::system(("touch " + file).c_str()), 0); // here it can
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST(ChildProcess, TellsHowItBrokeDown) {
  EXPECT_EQ(run([]() -> std::string { return std::to_string(std::raise(SIGSEGV)); }).signal, SIGSEGV);
  EXPECT_EQ(run([]() -> std::string { std::abort(); }).signal, SIGABRT);
  EXPECT_EQ(run([]() -> std::string { throw std::runtime_error("x"); }).signal, SIGABRT);
  const ChildEnd end = run([]() -> std::string { std::exit(0); });
  EXPECT_TRUE(end.exit);
  EXPECT_FALSE(end.returned);
  EXPECT_EQ(end.signal, 0);
}

TEST(ChildProcess, ChangesNothingHere) {
  int here = 1;
  std::string printed;
  std::cout << "waits in the buffer ";
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::cout << "before ";
  run(
      [&] {
        here = 2;
        std::setlocale(LC_ALL, "C.utf8");
        std::signal(SIGTERM, SIG_IGN);
        std::cout << "inside";
        std::cerr << " and beside";
        std::string line;
        return std::getline(std::cin, line) ? "read something" : "";
      },
      &printed);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "before ");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(printed, "inside and beside");
  EXPECT_EQ(here, 1);
  EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), "C");
  struct sigaction action;
  sigaction(SIGTERM, nullptr, &action);
  EXPECT_EQ(action.sa_handler, SIG_DFL);
}

TEST(ChildProcess, NeedsALog) {
  expect_invalid([] { run_in_child([] { return std::string(); }, "/nowhere/log"); },
                 "run_in_child: \"/nowhere/log\" cannot be written: No such file or directory");
}

TEST(MemoryLimit, EndsWithItsScope) {
  {
    const MemoryLimit limit(1e8);
    EXPECT_THROW(std::make_unique<std::vector<char>>(200000000), std::bad_alloc);
  }
  EXPECT_EQ(std::make_unique<std::vector<char>>(200000000)->size(), 200000000u);
}

TEST(Temporary, FilesAndFoldersAreRemoved) {
  std::string file, folder;
  {
    const TemporaryFile temporary("text\n", ".geo");
    const TemporaryFolder other;
    file = temporary.path();
    folder = other.path();
    EXPECT_EQ(file_content(file), "text\n");
    EXPECT_EQ(std::filesystem::path(file).extension(), ".geo");
    std::filesystem::copy(file, folder + "/inside");
    EXPECT_TRUE(std::filesystem::is_directory(folder));
  }
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_FALSE(std::filesystem::exists(folder));
  EXPECT_EQ(file_content(file), "");
}

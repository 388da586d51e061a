// Checkpoints on the disk: what goes in comes out; what is not whole, or of another program, machine or run, is refused by a
// sentence that says why and names the older one.
#include "base/file_error.hpp"
#include "base/temporary.hpp"
#include "checkpoint/checkpoint.hpp"
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

using namespace burnish;

namespace {

namespace fs = std::filesystem;

class Checkpoints : public testing::Test {
protected:
  TemporaryFolder folder;
  std::string path = folder.path() + "/run-1.checkpoint", older = path + OLDER;

  static Checkpoint at(double t) {
    Checkpoint checkpoint;
    checkpoint.t = t;
    checkpoint.t_end = 1;
    checkpoint.identity = {{"mesh", "4 nodes"}, {"script \"a.edp\"", "real a = 1;\nreal b = 2;\n"}};
    checkpoint.state = std::string("a\0b\n", 4) + std::string(5000, 'x');
    checkpoint.mesh = "nodes";
    checkpoint.script_mesh = std::string("\0vertices", 9);
    checkpoint.solver = "UMFPACK";
    checkpoint.files = {{"history.csv", 12}};
    checkpoint.values = {{"n", "int", "12345678"}};
    return checkpoint;
  }
  std::string bytes() const {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void put(const std::string& bytes) const { std::ofstream(path, std::ios::binary) << bytes; }
  std::string refusal() const {
    try {
      read_checkpoint(path);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
  void expect_refused(const std::string& why) const {
    EXPECT_NE(refusal().find(why), std::string::npos) << refusal();
    EXPECT_EQ(refusal().rfind("checkpoint \"" + path + "\"", 0), 0u) << refusal();
  }
};

} // namespace

TEST_F(Checkpoints, WhatGoesInComesOut) {
  write_checkpoint(path, at(0.5));
  const Checkpoint read = read_checkpoint(path), wrote = at(0.5);
  EXPECT_EQ(read.t, 0.5);
  EXPECT_EQ(read.t_end, 1);
  EXPECT_EQ(read.state, wrote.state);
  EXPECT_EQ(read.mesh, wrote.mesh);
  EXPECT_EQ(read.script_mesh, wrote.script_mesh);
  EXPECT_EQ(read.solver, wrote.solver);
  EXPECT_EQ(read.identity[1].value, wrote.identity[1].value);
  EXPECT_EQ(read.files[0].size, 12u);
  EXPECT_EQ(read.values[0].bytes, "12345678");
}

TEST_F(Checkpoints, TwoGenerationsAreKept) {
  for (const double t : {0.1, 0.2, 0.3}) write_checkpoint(path, at(t));
  EXPECT_EQ(read_checkpoint(path).t, 0.3);
  EXPECT_EQ(read_checkpoint(older).t, 0.2);
  fs::remove(path); // a kill between two moves, where the disk knows no hard links
  EXPECT_EQ(read_checkpoint(path).t, 0.2);
  write_checkpoint(path, at(0.4));
  EXPECT_EQ(read_checkpoint(older).t, 0.2) << "kept while there is no younger one";
}

TEST_F(Checkpoints, AKillWhileOneIsWrittenLeavesTheOneBefore) {
  write_checkpoint(path, at(0.1));
  std::ofstream(folder.path() + "/.new.run-1.checkpoint") << "half";
  EXPECT_EQ(read_checkpoint(path).t, 0.1);
  write_checkpoint(path, at(0.2));
  EXPECT_EQ(read_checkpoint(path).t, 0.2);
}

TEST_F(Checkpoints, WhatIsNotWholeIsRefused) {
  write_checkpoint(path, at(0.1));
  const std::string whole = bytes();
  put(whole.substr(0, whole.size() - 1));
  expect_refused("it is cut off");
  put(whole.substr(0, 20));
  expect_refused("is cut off in its head");
  put(whole + "x");
  expect_refused("it is damaged");
  for (const std::size_t at : {60u, 2000u, 5000u}) {
    std::string turned = whole;
    turned[at] = static_cast<char>(turned[at] ^ 1);
    put(turned);
    expect_refused("is damaged: its checksum is wrong");
  }
  put("t,x\n0,1\n");
  expect_refused("is no checkpoint of Burnish");
  put("");
  expect_refused("is no checkpoint of Burnish");
  fs::remove(path);
  expect_refused("cannot be read: No such file or directory");
}

TEST_F(Checkpoints, OfAnotherMachineFormatOrVersionIsRefused) {
  write_checkpoint(path, at(0.1));
  const std::string whole = bytes();
  std::string other = whole;
  std::reverse(other.begin() + 8, other.begin() + 12);
  put(other);
  expect_refused("of another byte order");
  other = whole;
  other[12] = 99;
  put(other);
  expect_refused("format = 99, expected 4");
  other = whole;
  other[16] = '7';
  put(other);
  expect_refused("version of Burnish = 7");
}

TEST_F(Checkpoints, TheOlderOneIsNamed) {
  write_checkpoint(path, at(0.1));
  write_checkpoint(path, at(0.2));
  put(bytes().substr(0, 4000));
  expect_refused("; the one before it, \"" + older + "\", of t = 0.1, is whole: -resume 2 goes on from it");
  EXPECT_EQ(read_checkpoint(older).t, 0.1);
}

TEST_F(Checkpoints, AFolderThatIsGoneIsAnErrorOfTheFile) {
  write_checkpoint(path, at(0.1));
  const std::string gone = folder.path() + "/gone/run-1.checkpoint";
  try {
    write_checkpoint(gone, at(0.2));
    FAIL() << "written";
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()),
              "checkpoint \"" + gone + "\" cannot be written: No such file or directory");
  }
}

TEST_F(Checkpoints, OfAnotherRunIsRefusedWithAllThatDiffers) {
  const std::vector<IdentityPart> then = at(0).identity;
  EXPECT_NO_THROW(require_same(path, then, then));
  std::vector<IdentityPart> now = then;
  now[0].value = "5 nodes";
  now[1].value = "real a = 1;\nreal b = 3;\n";
  now.push_back({"option -mu", "0.2"});
  try {
    require_same(path, then, now);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()),
              "checkpoint \"" + path +
                  "\": is of another run: mesh = 5 nodes, expected 4 nodes; script \"a.edp\" says `real b = "
                  "3;`, expected `real b = 2;`; option -mu is new");
  }
  EXPECT_THROW(require_same(path, now, then), std::invalid_argument) << "-mu is missing";
}

TEST_F(Checkpoints, GrowingFilesAreCutToWhatTheyWere) {
  const std::string history = folder.path() + "/history.csv";
  std::ofstream(history) << "t\n0\n1\n";
  const auto files = growing_files({history, folder.path() + "/gone.csv"}, folder.path());
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].path, "history.csv") << "relative, so that the folder can be moved";
  EXPECT_EQ(files[0].size, 6u);
  std::ofstream(history, std::ios::app) << "2\n3";
  EXPECT_EQ(cut_files(files, folder.path()), std::vector<std::string>{history});
  EXPECT_EQ(fs::file_size(history), 6u);
  std::ofstream(history) << "t\n";
  EXPECT_THROW(cut_files(files, folder.path()), std::invalid_argument) << "of another run";
  fs::remove(history);
  EXPECT_THROW(cut_files(files, folder.path()), std::invalid_argument);
}

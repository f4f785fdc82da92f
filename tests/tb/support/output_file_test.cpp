// Files that are whole or an error.
#include "tb/support/output_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tb/report/report.h"
#include "tb/support/replace_file.h"
#include "tests/support/error_of.h"
#include "tests/support/folder.h"

namespace cosim {
namespace {

namespace fs = std::filesystem;

class OutputFileOf : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }
  static std::string text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  test::Folder folder_;
};

TEST_F(OutputFileOf, Lines) {
  OutputFile file(path("a"));
  file.line("{} {:02}", "one", 2);
  file.line("");
  file.close();
  EXPECT_EQ(text(path("a")), "one 02\n\n");
}

TEST_F(OutputFileOf, ManyLinesAreAllThere) {
  OutputFile file(path("a"));
  std::string expected;
  for (int i = 0; i < 100'000; ++i) {
    file.line("{}", i);
    expected += std::to_string(i) + "\n";
  }
  file.close();
  EXPECT_EQ(text(path("a")), expected);
}

TEST_F(OutputFileOf, WhatStoodThereIsGone) {
  std::ofstream(path("a")) << "much longer than before";
  OutputFile file(path("a"));
  file.line("new");
  file.close();
  EXPECT_EQ(text(path("a")), "new\n");
}

TEST_F(OutputFileOf, TheOldTextStandsUntilTheNewIsWhole) {
  std::ofstream(path("a")) << "old";
  {
    OutputFile file(path("a"));
    file.text("new");
    EXPECT_EQ(text(path("a")), "old");
  }
  EXPECT_EQ(text(path("a")), "old");
  { OutputFile(path("b")).text("half"); }
  EXPECT_FALSE(fs::exists(path("b")));
  EXPECT_EQ(std::distance(fs::directory_iterator(path("")), {}), 1);
}

// The name that every half file had once: what is there belongs to somebody.
TEST_F(OutputFileOf, FilesOfTheUserStay) {
  std::ofstream(path("mine")) << "mine";
  std::ofstream(path("b.cosim-new")) << "mine too";
  fs::create_symlink(path("mine"), path("a.cosim-new"));
  for (const char* name : {"a", "b"}) {
    OutputFile file(path(name));
    file.line("new");
    file.close();
    replace_file(path(name), "newer");
    EXPECT_EQ(text(path(name)), "newer");
  }
  EXPECT_EQ(text(path("mine")), "mine");
  EXPECT_EQ(text(path("b.cosim-new")), "mine too");
  EXPECT_TRUE(fs::is_symlink(path("a.cosim-new")));
}

// Even one that guesses the name: nothing is written through a link.
TEST_F(OutputFileOf, ALinkOfThatNameIsNotFollowed) {
  std::ofstream(path("mine")) << "mine";
  fs::create_symlink(path("mine"), path("half"));
  EXPECT_EQ(open_beside(path("a"), path("half")), -1);
  EXPECT_EQ(text(path("mine")), "mine");
  EXPECT_NE(beside("a"), beside("a"));
}

TEST_F(OutputFileOf, NoPathWritesNothing) {
  OutputFile file("");
  file.line("{}", 1);
  file.close();
}

TEST_F(OutputFileOf, ClosedTwiceIsClosed) {
  OutputFile file(path("a"));
  file.line("x");
  file.close();
  file.close();
  EXPECT_EQ(text(path("a")), "x\n");
}

TEST_F(OutputFileOf, APathThatCannotBeWritten) {
  EXPECT_EQ(test::error_of([&] { OutputFile file(path("none/a")); }),
            path("none/a") + ": cannot write: No such file or directory");
  EXPECT_EQ(test::error_of([&] { OutputFile file(path("")); }),
            path("") + ": cannot write: Is a directory");
}

TEST_F(OutputFileOf, AFullDevice) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "not here: there is no /dev/full";
  const std::string error = "/dev/full: cannot write: No space left on device";
  EXPECT_EQ(test::error_of([] {
              OutputFile file("/dev/full");
              file.line("a line");
              file.close();
            }),
            error);
  EXPECT_EQ(test::error_of([] {
              OutputFile file("/dev/full");
              for (int i = 0; i < 1'000'000; ++i) file.line("a line");  // long before the close
            }),
            error);
  EXPECT_EQ(test::error_of([] { write_report("/dev/full", "{}"); }), error);
}

TEST_F(OutputFileOf, AReport) {
  write_report(path("r"), "{}");
  EXPECT_EQ(text(path("r")), "{}\n");
  write_report("", "{}");
}

}  // namespace
}  // namespace cosim

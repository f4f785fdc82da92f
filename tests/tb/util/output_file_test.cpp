// Files that are whole or an error.
#include "tb/util/output_file.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tb/sim/report.h"
#include "tests/support/error_of.h"
#include "tests/support/folder.h"

namespace cosim {
namespace {

namespace fs = std::filesystem;

using OutputFileOf = test::InAFolder;

// A file of that line.
void write_line(const std::string& path, const char* line) {
  OutputFile file(path);
  file.line("{}", line);
  file.close();
}

TEST_F(OutputFileOf, Lines) {
  OutputFile file(folder.path("a"));
  file.line("{} {:02}", "one", 2);
  file.line("");
  file.close();
  EXPECT_EQ(folder.text("a"), "one 02\n\n");
}

TEST_F(OutputFileOf, ManyLinesAreAllThere) {
  OutputFile file(folder.path("a"));
  std::string expected;
  for (int i = 0; i < 100'000; ++i) {
    file.line("{}", i);
    expected += std::to_string(i) + "\n";
  }
  file.close();
  EXPECT_EQ(folder.text("a"), expected);
}

TEST_F(OutputFileOf, WhatStoodThereIsGone) {
  folder.write("a", "much longer than before");
  write_line(folder.path("a"), "new");
  EXPECT_EQ(folder.text("a"), "new\n");
}

TEST_F(OutputFileOf, TheOldTextStandsUntilTheNewIsWhole) {
  folder.write("a", "old");
  {
    OutputFile file(folder.path("a"));
    file.text("new");
    EXPECT_EQ(folder.text("a"), "old");
  }
  EXPECT_EQ(folder.text("a"), "old");
  { OutputFile(folder.path("b")).text("half"); }
  EXPECT_FALSE(fs::exists(folder.path("b")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path("")), {}), 1);
}

// The name that every half file had once: what is there belongs to somebody.
TEST_F(OutputFileOf, FilesOfTheUserStay) {
  folder.write("mine", "mine");
  folder.write("b.cosim-new", "mine too");
  fs::create_symlink(folder.path("mine"), folder.path("a.cosim-new"));
  for (const char* name : {"a", "b"}) {
    write_line(folder.path(name), "new");
    write_file(folder.path(name), "newer");
    EXPECT_EQ(folder.text(name), "newer");
  }
  EXPECT_EQ(folder.text("mine"), "mine");
  EXPECT_EQ(folder.text("b.cosim-new"), "mine too");
  EXPECT_TRUE(fs::is_symlink(folder.path("a.cosim-new")));
}

// Even one that guesses the name: nothing is written through a link.
TEST_F(OutputFileOf, ALinkOfThatNameIsNotFollowed) {
  folder.write("mine", "mine");
  fs::create_symlink(folder.path("mine"), folder.path("half"));
  EXPECT_EQ(open_beside(folder.path("a"), folder.path("half")), -1);
  EXPECT_EQ(folder.text("mine"), "mine");
  EXPECT_NE(beside("a"), beside("a"));
}

TEST_F(OutputFileOf, NoPathWritesNothing) { write_line("", "1"); }

TEST_F(OutputFileOf, ClosedTwiceIsClosed) {
  OutputFile file(folder.path("a"));
  file.line("x");
  file.close();
  file.close();
  EXPECT_EQ(folder.text("a"), "x\n");
}

TEST_F(OutputFileOf, APathThatCannotBeWritten) {
  EXPECT_EQ(test::error_of([&] { OutputFile file(folder.path("none/a")); }),
            folder.path("none/a") + ": cannot write: No such file or directory");
  EXPECT_EQ(test::error_of([&] { OutputFile file(folder.path("")); }),
            folder.path("") + ": cannot write: Is a directory");
}

TEST_F(OutputFileOf, AFullDevice) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "not here: there is no /dev/full";
  const std::string error = "/dev/full: cannot write: No space left on device";
  EXPECT_EQ(test::error_of([] { write_line("/dev/full", "a line"); }), error);
  EXPECT_EQ(test::error_of([] {
              OutputFile file("/dev/full");
              for (int i = 0; i < 1'000'000; ++i) file.line("a line");  // long before the close
            }),
            error);
  EXPECT_EQ(test::error_of([] { write_report("/dev/full", "{}"); }), error);
}

TEST_F(OutputFileOf, AReport) {
  write_report(folder.path("r"), "{}");
  EXPECT_EQ(folder.text("r"), "{}\n");
  write_report("", "{}");
}

}  // namespace
}  // namespace cosim

// A folder of results takes the place of an older one, and of nothing else.
#include "tb/util/draft.h"

#include <gtest/gtest.h>

#include "model/core/input_error.h"
#include "tests/support/error_of.h"
#include "tests/support/folder.h"

namespace cosim {
namespace {

namespace fs = std::filesystem;

class DraftFolder : public test::InAFolder {
 protected:
  void write(const std::string& text) const {
    Draft draft(folder.path("root"), "it");
    draft.write("report.txt", text);
    fs::create_directory(draft.folder() / "inner");
    draft.write("inner/" + text, text);
    draft.finish_replacing();
  }
  std::string refusal() const {
    return test::error_of([&] { write("second"); });
  }
  // What is in the place of the draft's folder before it.
  void expect_refused(const std::string& said) {
    EXPECT_EQ(refusal(), folder.path("root/it") + said);
    EXPECT_FALSE(fs::exists(folder.path("root/it/inner/second")));
    for (const auto& one : fs::directory_iterator(folder.path("root"))) {
      EXPECT_EQ(one.path().filename(), "it");
    }
  }
};

TEST_F(DraftFolder, ReplacesItsOwn) {
  write("first");
  write("second");
  EXPECT_EQ(folder.text("root/it/report.txt"), "second");
  EXPECT_TRUE(fs::exists(folder.path("root/it/inner/second")));
  EXPECT_FALSE(fs::exists(folder.path("root/it/inner/first")));
}

TEST_F(DraftFolder, ReplacesAnEmptyOne) {
  fs::create_directories(folder.path("root/it"));
  write("second");
  EXPECT_EQ(folder.text("root/it/report.txt"), "second");
}

TEST_F(DraftFolder, LeavesAFileThatAPersonPutThere) {
  write("first");
  for (const char* name : {"notes.txt", "inner/notes.txt"}) {
    const std::string file = folder.write(std::string("root/it/") + name, "mine");
    expect_refused(std::string(": has ") + name +
                   ", which is not from an earlier run: nothing is replaced; move that file");
    EXPECT_EQ(folder.text(std::string("root/it/") + name), "mine");
    fs::remove(file);
  }
  write("second");
}

TEST_F(DraftFolder, LeavesAFolderOfThatNameThatNoDraftWrote) {
  fs::create_directories(folder.path("root/it"));
  folder.write("root/it/report.txt", "mine");
  expect_refused(
      ": has report.txt, which is not from an earlier run: nothing is replaced; move that file");
  EXPECT_EQ(folder.text("root/it/report.txt"), "mine");
}

TEST_F(DraftFolder, LeavesAFileAndALinkOfThatName) {
  fs::create_directories(folder.path("root"));
  const std::string file = folder.write("root/it", "mine");
  expect_refused(": is not a folder and is not replaced; move it or name another");
  EXPECT_EQ(folder.text("root/it"), "mine");
  fs::remove(file);
  fs::create_directory_symlink(folder.path(""), file);
  EXPECT_EQ(refusal(), file + ": is not a folder and is not replaced; move it or name another");
  EXPECT_TRUE(fs::is_symlink(file));
}

}  // namespace
}  // namespace cosim

// A check of an exporter's files is kept until one of them changes, and only where it passes.
#include "tb/nets/check_once.h"

#include <gtest/gtest.h>

#include "model/core/input_error.h"
#include "tests/support/folder.h"

namespace cosim::nets {
namespace {

TEST(CheckOnce, RunsAgainWhereAFileOfTheModelChanges) {
  const test::Folder folder;
  const std::string file = folder.path("fifo_0");
  int runs = 0;
  const auto check = [&](const char* name) { check_once(file, name, [&] { ++runs; }); };
  folder.write("fifo_0.btor2", "1 sort bitvec 1\n");
  check("clock");
  check("clock");
  EXPECT_EQ(runs, 1);
  check("jobs");
  EXPECT_EQ(runs, 2);
  folder.write("fifo_0.btor2", "1 sort bitvec 2\n");
  check("clock");
  EXPECT_EQ(runs, 3);
  folder.write("fifo_0.driver.btor2", "1 sort bitvec 1\n");
  check("clock");
  EXPECT_EQ(runs, 4);
}

TEST(CheckOnce, KeepsNoFailure) {
  const test::Folder folder;
  const std::string file = folder.path("fifo_0");
  folder.write("fifo_0.btor2", "");
  int runs = 0;
  const auto fails = [&] {
    ++runs;
    throw InputError("fifo: full is 1 in the model");
  };
  EXPECT_THROW(check_once(file, "clock", fails), InputError);
  EXPECT_THROW(check_once(file, "clock", fails), InputError);
  EXPECT_EQ(runs, 2);
}

}  // namespace
}  // namespace cosim::nets

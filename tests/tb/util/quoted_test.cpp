// Names in the texts of other programs.
#include "tb/util/quoted.h"

#include <gtest/gtest.h>

#include "model/core/input_error.h"

namespace cosim {
namespace {

TEST(Quoted, AFileForYosysIsOneWordAndNoPattern) {
  EXPECT_EQ(file_for_yosys("/a b;c/#1.v"), "\"/a b;c/#1.v\"");
  EXPECT_EQ(file_for_yosys("/a[1]*?.v"), "\"/a\\[1]\\*\\?.v\"");
  EXPECT_THROW(file_for_yosys("/x\"; exec -- touch y; log \".v"), InputError);
  EXPECT_THROW(file_for_yosys("/x\ny.v"), InputError);
}

TEST(Quoted, AWordForYosysIsOneOrRefused) {
  EXPECT_EQ(word_for_yosys("-DWIDTH=8'h1F"), "-DWIDTH=8'h1F");
  for (const char* hostile : {"", "a b", "a;", "\"a", "#a", "a\nb", "a\tb"}) {
    EXPECT_THROW(word_for_yosys(hostile), InputError) << hostile;
  }
}

TEST(Quoted, ForAShell) {
  EXPECT_EQ(for_shell("build/a-b_c.1"), "build/a-b_c.1");
  EXPECT_EQ(for_shell(""), "''");
  EXPECT_EQ(for_shell("a=b/program"), "'a=b/program'");
  EXPECT_EQ(for_shell("it's $HOME"), "'it'\\''s $HOME'");
}

TEST(Quoted, ForCMake) {
  EXPECT_EQ(for_cmake("a-b.v"), "a-b.v");
  EXPECT_EQ(for_cmake(""), "\"\"");
  EXPECT_EQ(for_cmake("a)b"), "\"a)b\"");
  EXPECT_EQ(for_cmake("$ENV{HOME}\\\""), "\"\\$ENV{HOME}\\\\\\\"\"");
  EXPECT_THROW(for_cmake("a;b"), InputError);
  EXPECT_THROW(for_cmake("a\nb"), InputError);
}

TEST(Quoted, ForGnuplot) {
  EXPECT_EQ(for_gnuplot("it's `touch x`"), "'it''s `touch x`'");
  EXPECT_THROW(for_gnuplot("a'\nsystem 'touch x'"), InputError);
}

}  // namespace
}  // namespace cosim

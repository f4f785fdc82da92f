// What counted runs have left in files, added up.
#include "tb/coverage/points.h"

#include <gtest/gtest.h>

#include <fstream>

#include "model/core/input_error.h"
#include "tb/support/process.h"

namespace cosim::coverage {
namespace {

// A line of Verilator's. `h` is the instance.
std::string counted(const std::string& kind, int line, const std::string& what,
                    const std::string& instance, int hits) {
  return "C '\1f\2/some where/part.v\1l\2" + std::to_string(line) + "\1n\0025\1t\2" + kind +
         "\1page\2v_" + kind + "/part\1o\2" + what + "\1h\2" + instance + "' " +
         std::to_string(hits) + "\n";
}

class CoveragePoints : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(scratch_.path() / name) << text;
  }
  Points read() const { return read_points(scratch_.path().string()); }

 private:
  Scratch scratch_;
};

TEST_F(CoveragePoints, OfAllInstancesAndFilesAreAddedUp) {
  write("Vpart_W4.12.0", "# SystemC::Coverage-3\n" +
                             counted("toggle", 12, "count[3]", "TOP.top.one", 3) +
                             counted("toggle", 12, "count[3]", "TOP.top.two.part", 4) +
                             counted("line", 7, "block", "TOP.top.one", 0));
  write("Vpart_W8.13.0", counted("toggle", 12, "count[3]", "TOP.top.one", 5) +
                             counted("toggle", 12, "word__024a[4]", "TOP.top.one", 0));
  const Points all = read();
  ASSERT_EQ(all.rtl.size(), 3);
  EXPECT_EQ(all.rtl[0].kind, "line");
  EXPECT_EQ(all.rtl[0].file, "/some where/part.v");
  EXPECT_EQ(all.rtl[0].line, 7);
  EXPECT_EQ(all.rtl[0].column, 5);
  EXPECT_EQ(all.rtl[0].what, "block");
  EXPECT_EQ(all.rtl[0].hits, 0);
  EXPECT_EQ(all.rtl[1].kind, "toggle");
  EXPECT_EQ(all.rtl[1].what, "count[3]");
  EXPECT_EQ(all.rtl[1].hits, 12);
  EXPECT_EQ(all.rtl[1].instances, (std::vector<std::string>{"one", "two.part"}));
  EXPECT_EQ(all.rtl[2].what, "word$a[4]");
  EXPECT_EQ(all.rtl[2].hits, 0);
  EXPECT_TRUE(all.cases.empty());
}

TEST_F(CoveragePoints, ToggledByTheStimuliOnly) {
  write("before.Vpart.12.0",
        counted("toggle", 12, "count[3]", "TOP.a", 3) + counted("line", 7, "block", "TOP.a", 2));
  write("Vpart.12.1",
        counted("toggle", 12, "count[3]", "TOP.a", 0) + counted("line", 7, "block", "TOP.a", 5));
  const Points all = read();
  ASSERT_EQ(all.rtl.size(), 2);
  EXPECT_EQ(all.rtl[0].what, "block");
  EXPECT_EQ(all.rtl[0].hits, 7);
  EXPECT_EQ(all.rtl[1].what, "count[3]");
  EXPECT_EQ(all.rtl[1].hits, 0);
}

TEST_F(CoveragePoints, SoAreCases) {
  write("cases.12.0", "part\ta byte is sent\t3\npart\ta byte waits\t0\n");
  write("cases.13.0", "part\ta byte is sent\t4\npart\ta byte waits\t0\n");
  const Points all = read();
  ASSERT_EQ(all.cases.size(), 2);
  EXPECT_EQ(all.cases[0].name, "a byte is sent");
  EXPECT_EQ(all.cases[0].hits, 7);
  EXPECT_EQ(all.cases[1].name, "a byte waits");
  EXPECT_EQ(all.cases[1].hits, 0);
}

TEST_F(CoveragePoints, AnotherTextIsNone) {
  write("Vpart.1.0", "something else\n");
  EXPECT_THROW(read(), InputError);
  write("Vpart.1.0", "C '\1f\2part.v\1l\2x\1n\0025\1o\2block' 1\n");
  EXPECT_THROW(read(), InputError);
  write("Vpart.1.0", "C '\1f\2part.v\1l\0021\1n\0025\1o\2block' many\n");
  EXPECT_THROW(read(), InputError);
}

}  // namespace
}  // namespace cosim::coverage

// What counted runs have left in files, added up.
#include "tb/sim/asked.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/folder.h"

namespace cosim::coverage {
namespace {

// A line of Verilator's. `h` is the instance.
std::string counted(const std::string& kind, int line, const std::string& what,
                    const std::string& instance, int hits) {
  return "C '\1f\2/some where/part.v\1l\2" + std::to_string(line) + "\1n\0025\1t\2" + kind +
         "\1page\2v_" + kind + "/part\1o\2" + what + "\1h\2" + instance + "' " +
         std::to_string(hits) + "\n";
}

class CoveragePoints : public test::InAFolder {
 protected:
  Points read() const { return read_points(folder.path("")); }
};

using Texts = std::vector<std::string>;

// "count[3] 12": what it is, and how often.
Texts told(const Points& all) {
  Texts texts;
  for (const auto& p : all.places) texts.push_back(p.what + ' ' + std::to_string(p.hits));
  for (const auto& c : all.cases) texts.push_back(c.name + ' ' + std::to_string(c.hits));
  return texts;
}

TEST_F(CoveragePoints, OfAllInstancesAndFilesAreAddedUp) {
  folder.write("Vpart_W4.12.0", "# SystemC::Coverage-3\n" +
                                    counted("toggle", 12, "count[3]", "TOP.top.one", 3) +
                                    counted("toggle", 12, "count[3]", "TOP.top.two.part", 4) +
                                    counted("line", 7, "block", "TOP.top.one", 0));
  folder.write("Vpart_W8.13.0", counted("toggle", 12, "count[3]", "TOP.top.one", 5) +
                                    counted("toggle", 12, "word__024a[4]", "TOP.top.one", 0));
  const Points all = read();
  ASSERT_EQ(told(all), (Texts{"block 0", "count[3] 12", "word$a[4] 0"}));
  EXPECT_EQ(all.places[0].kind, "line");
  EXPECT_EQ(all.places[0].file, "/some where/part.v");
  EXPECT_EQ(all.places[0].line, 7);
  EXPECT_EQ(all.places[0].column, 5);
  EXPECT_EQ(all.places[1].kind, "toggle");
  EXPECT_EQ(all.places[1].instances, (Texts{"one", "two.part"}));
  EXPECT_TRUE(all.cases.empty());
}

TEST_F(CoveragePoints, AWayIsTheSameInEachShape) {
  const std::string way = "way\t/uart.h\t38\ttrue: if (left != 0); after 27 false";
  folder.write("ways.12.0", "uart\t" + way + "\t3\nuart\tbranch\t/uart.h\t40\tfalse: if (x)\t0\n");
  folder.write("ways.13.0", "uart\t" + way + "\t4\n");
  const Points all = read();
  ASSERT_EQ(told(all), (Texts{"true: if (left != 0); after 27 false 7", "false: if (x) 0"}));
  EXPECT_EQ(all.places[0].kind, "model way");
  EXPECT_EQ(all.places[0].line, 38);
  EXPECT_EQ(name_in_model(all.places[0]), way);
}

TEST_F(CoveragePoints, ToggledByTheStimuliOnly) {
  folder.write("before.Vpart.12.0", counted("toggle", 12, "count[3]", "TOP.a", 3) +
                                        counted("line", 7, "block", "TOP.a", 2));
  folder.write("Vpart.12.1", counted("toggle", 12, "count[3]", "TOP.a", 0) +
                                 counted("line", 7, "block", "TOP.a", 5));
  EXPECT_EQ(told(read()), (Texts{"block 7", "count[3] 0"}));
}

TEST_F(CoveragePoints, SoAreCases) {
  folder.write("cases.12.0", "part\ta byte is sent\t3\npart\ta byte waits\t0\n");
  folder.write("cases.13.0", "part\ta byte is sent\t4\npart\ta byte waits\t0\n");
  EXPECT_EQ(told(read()), (Texts{"a byte is sent 7", "a byte waits 0"}));
}

TEST_F(CoveragePoints, AnotherTextIsNone) {
  folder.write("Vpart.1.0", "something else\n");
  EXPECT_THROW(read(), InputError);
  folder.write("Vpart.1.0", "C '\1f\2part.v\1l\2x\1n\0025\1o\2block' 1\n");
  EXPECT_THROW(read(), InputError);
  folder.write("Vpart.1.0", "C '\1f\2part.v\1l\0021\1n\0025\1o\2block' many\n");
  EXPECT_THROW(read(), InputError);
}

}  // namespace
}  // namespace cosim::coverage

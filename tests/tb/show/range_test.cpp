// Ports with the range of their source, and names that are escaped in Verilog: in the wave and in
// its view alike.
#include <gtest/gtest.h>

#include "tb/show/wave.h"
#include "tests/support/folder.h"
#include "tests/support/has.h"
#include "tests/support/vcd.h"

namespace cosim {
namespace {

TEST(WaveRanges, AreThoseOfTheSource) {
  const test::Folder folder;
  WaveShape shape;
  shape.inputs = {{"\\a.b[0]", 1, Format::flag, "", ""}, {"addr", 4, Format::bits, "", ""}};
  shape.compared = {{"\\x{y}", 4, Format::bits, "", ""}};
  shape.ranges = {{"addr", "[0:3]"}, {"\\x{y}", "[7:4]"}};
  WaveRange range;
  range.clocks = 1;
  range.last = 0;
  {
    Wave wave(folder.path("it.fst"));
    wave.begin(shape, range, {});
    WaveClock now;
    now.inputs = {1, 5};
    now.expected = now.actual = {9};
    now.compared = {true};
    now.differs = {false};
    wave.clock(now);
    wave.end(range);
  }
  test::expect_has(folder.text("it.gtkw"),
                   {"+{\\a.b[0]} cosim.inputs.\\a.b[0]\n", "+{addr} cosim.inputs.addr[0:3]\n",
                    "+{\\x(y)} cosim.actual.\\x{y}[7:4]\n"});
  if (!test::can_read_waves()) GTEST_SKIP() << "no fst2vcd";
  const test::Vcd vcd(folder.path("it.fst"));
  EXPECT_EQ(vcd.at("cosim.inputs.addr", 2), "0101");
}

}  // namespace
}  // namespace cosim

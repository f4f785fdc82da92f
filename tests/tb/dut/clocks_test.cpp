// Several clocks in the tables of a design, against those that the RTL's text has.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tb/dut/named_adapter.h"
#include "tests/support/error_of.h"

namespace cosim {
namespace {

Field input(const char* name, Edge edge) {
  Field f{name, 1, Format::flag, "", "", 0, name};
  f.edge = edge;
  return f;
}

// What is said of a design with these edges of w_clk and r_clk; of the RTL the one rises, the other
// falls.
std::string said_of(Edge w, Edge r) {
  std::uint8_t w_clk = 0, r_clk = 0;
  const std::vector<PortNet> rtl{port_net("w_clk", true, 1, 0, w_clk),
                                 port_net("r_clk", true, 1, 0, r_clk)};
  Ports ports{"made", "", {input("w_clk", w), input("r_clk", r)}, {}};
  ports.clocks = "w_clk\nfalling r_clk";
  return test::error_of([&] {
    const std::vector<Net> nets = find_ports(rtl, ports);
    EXPECT_EQ(nets.at(0).data, &w_clk);
    EXPECT_EQ(nets.at(1).data, &r_clk);
    EXPECT_EQ(nets.at(2).data, nullptr);
  });
}

TEST(ClocksOfTheTables, AreThoseOfTheRtl) {
  EXPECT_EQ(said_of(Edge::rising, Edge::falling), "");
  EXPECT_EQ(said_of(Edge::rising, Edge::none),
            "made: r_clk is a clock: the model must declare it as Falls");
  EXPECT_EQ(said_of(Edge::none, Edge::falling),
            "made: w_clk is a clock: the model must declare it as Rises");
  EXPECT_EQ(said_of(Edge::rising, Edge::rising),
            "made: input r_clk: the model declares it as Rises, but the RTL has no such clock");
}

}  // namespace
}  // namespace cosim

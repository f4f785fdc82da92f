// cosim equiv: what says that a proof is one; and RTL with parameters against a netlist, which has
// none, and other names for its registers.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tb/util/json.h"
#include "tb/util/read_file.h"
#include "tests/cli/equiv_pairs.h"

namespace cosim::cli {
namespace {

const std::string behind =
    module_of(", input [1:0] d, output q",
              "reg [1:0] x; always @(posedge clk) if (rst) x <= 0; else x <= d; assign q = ^x;");
const std::string in_front =
    module_of(", input [1:0] d, output reg q", "always @(posedge clk) q <= rst ? 0 : ^d;");

TEST(EquivCheck, ASequentialProofIsCheckedByASolver) {
  const Folder folder;
  const std::string report = folder.path("report.json");
  const Ended ended = ends(0, equiv(behind, in_front, {"--seconds", "300", "--report", report}));
  EXPECT_TRUE(has(ended.out, "; checked by "));
  const Json json = json_of(read_file(report));
  EXPECT_EQ(json.at("check").at("by"), "cadical");
  EXPECT_GT(json.at("check").at("equalities").get<int>(), 0);
}

const char* const of_any_width =
    "module m #(parameter W = 8)(input clk, rst, input [W-1:0] d, output [W-1:0] q);\n"
    "reg [W-1:0] sum; always @(posedge clk) sum <= rst ? 0 : sum + d; assign q = ~sum;\n"
    "endmodule\n";

std::string netlist(const std::string& high_bit) {
  return module_of(", input [1:0] d, output [1:0] q",
                   "wire [1:0] sum = {a_high, a_low}; assign q = ~sum; reg a_low, a_high;"
                   "always @(posedge clk) a_low <= rst ? 0 : a_low ^ d[0];"
                   "always @(posedge clk) a_high <= rst ? 0 : " +
                       high_bit + ";");
}

TEST(EquivNetlist, TheParametersAreOfTheRtlAlone) {
  expect_said(0, of_any_width, netlist("sum[1] ^ d[1] ^ (sum[0] & d[0])"), "registers by name",
              {"--gold-param", "W=2"});
  expect_different(of_any_width, netlist("sum[1] ^ d[1]"), "q is ", {"--gold-param", "W=2"});
  expect_refused(equiv(of_any_width, of_any_width, {"--gold-param", "W=2"}), "the ports differ");
  expect_equal(of_any_width, of_any_width, {"--gold-param", "W=2", "--gate-param", "W=2"});
}

}  // namespace
}  // namespace cosim::cli

// What a simulation of both the RTL and its netlist is given.
#include <gtest/gtest.h>

#include <algorithm>

#include "tb/equiv/referee.h"
#include "tb/util/output_file.h"
#include "tb/util/process.h"
#include "tb/util/scratch.h"

namespace cosim::equiv {
namespace {

// Not only what is compared: a front end may have lost the comparison.
TEST(RefereeInputs, HaveTheNumbersOfTheText) {
  if (!is_installed("yosys")) GTEST_SKIP() << "no yosys";
  const Scratch scratch;
  const std::string file = (scratch.path() / "t.v").string();
  write_file(file,
             "module t(input [31:0] d, input [8:0] e, output [31:0] y);\n"
             "  assign y = d + 32'hdead_beef + 9'd300 + 300;  // 9'd77\nendmodule\n");
  Files files;
  files.files = {file};
  files.top = "t";
  const Budget budget(60);
  const Side side(files, "the RTL", FrontEnd::yosys, budget);
  const Referee how{false, {}, true, false, budget.ends()};
  RefereeInputs inputs(side, how);
  std::vector<std::string> d, e;
  for (std::size_t clock = 0; clock < 500; ++clock) {
    const RefereeInputs::Row row = inputs.row(clock);
    d.push_back(row.at("d"));
    e.push_back(row.at("e"));
  }
  EXPECT_GT(std::ranges::count(d, "11011110101011011011111011101111"), 20);
  EXPECT_GT(std::ranges::count(e, "100101100"), 20);
  EXPECT_LT(std::ranges::count(e, "001001101"), 20);  // of a comment
}

}  // namespace
}  // namespace cosim::equiv

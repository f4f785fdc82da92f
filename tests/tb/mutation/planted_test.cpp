// Mutants that yosys plants in RTL.
#include <gtest/gtest.h>

#include "tb/mutation/subject.h"
#include "tb/util/output_file.h"
#include "tb/util/process.h"
#include "tb/util/scratch.h"

namespace cosim::mutation {
namespace {

TEST(Planted, AreMadeOfAFileInAFolderWithABlank) {
  if (!is_installed("yosys")) GTEST_SKIP() << "no yosys";
  const Scratch scratch;
  const auto folder = scratch.path() / "a b" / "rtl";
  std::filesystem::create_directories(folder);
  write_file((folder / "t.v").string(),
             "module t(input clk, input [3:0] d, output reg [3:0] q);\n"
             "  always @(posedge clk) q <= d + 3;\nendmodule\n");
  proof::Source source;
  source.files = {folder / "t.v"};
  source.top = "t";
  const Planted planted(source, 3);
  ASSERT_EQ(planted.mutants().size(), 3U);
  for (const unsigned one : {1U, 2U, 3U}) EXPECT_EQ(planted.nets({one}).flip_flops().size(), 4U);
}

}  // namespace
}  // namespace cosim::mutation

// What yosys says of wrong RTL, in a line that a person can act on.
#include "tb/equiv/yosys_messages.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tb/util/pattern.h"
#include "tb/util/read_file.h"
#include "tests/support/folder.h"
#include "tests/support/root.h"

namespace cosim::equiv {
namespace {

TEST(YosysMessages, AreALineOfWhatIsWrongAndWhere) {
  std::istringstream all(
      read_file((test::project_root() / "tests/tb/equiv/yosys_messages.txt").string()));
  static const Pattern ends("=> (\\d+) (.*)"),
      own("\\$(proc|procmux|auto|paramod|abstract)|/scratch|'m\\b|this signal|TOK_|\\.cc:|kernel");
  std::size_t met = 0;
  std::string said;
  for (std::string line; std::getline(all, line);) {
    const Pattern::Parts part = ends.whole(line);
    if (line.empty()) said.clear();
    if (!line.empty() && part.empty()) said += line + '\n';
    if (part.empty()) continue;
    const std::string message =
        yosys_message(said, std::stoi(part[1]), {{"/scratch/folder0", "rtl"}});
    EXPECT_EQ(message, part[2]) << said;
    EXPECT_FALSE(own.in(message)) << message;
    ++met;
  }
  EXPECT_GT(met, 80U);
}

TEST(YosysMessages, ASyntaxErrorShowsItsLine) {
  const test::Folder folder;
  const std::string file = folder.write("t.v", "module t;\n  logic a;\nendmodule\n");
  EXPECT_EQ(yosys_message("/scratch/t.v:2: ERROR: syntax error, unexpected TOK_ID\n", 1,
                          {{"/scratch/t.v", file}}),
            file +
                ":2: syntax error: a name is not expected: logic a; (SystemVerilog is read from "
                "files .sv)");
}

TEST(YosysMessages, NothingSaidIsSaidSo) {
  EXPECT_EQ(yosys_message("", 1, {}), "yosys ends without a reason");
  EXPECT_EQ(yosys_message("", 139, {}),
            "yosys crashes: does a module or a function have itself in it?");
}

}  // namespace
}  // namespace cosim::equiv

// Bad input gets one line on standard error, exit status 2, and loses nothing.
#include <algorithm>

#include "tests/cli/command.h"

namespace cosim::test {
namespace {

struct Bad {
  const char* arguments;
  const char* says;  ///< what the line has to hold
};

class BadInput : public Command, public testing::WithParamInterface<Bad> {};

TEST_P(BadInput, GetsOneLineAndStatus2) {
  write("empty.ngc", "");
  write("still.ngc", "G21 G90\nF100\n");
  write("binary.ngc", std::string("G0 X1\0\x01\x02", 8));
  write("radius.ngc", "G21\nG0 X0 Y0\nG2 X5 Y5\n");
  write("offset.ngc", "G0 X1\n  G55 X2\n");
  write("huge.ngc", "G0 X1e999\n");
  write("nan.ngc", "G0 Xnan\n");
  write("far.ngc", "G0 X900000000\n");
  write("keep.csv", "kept\n");
  const Said said = run(GetParam().arguments);
  EXPECT_EQ(said.status, 2) << said.out << said.err;
  EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
  EXPECT_EQ(said.err.rfind("cosim: ", 0), 0U) << said.err;
  EXPECT_NE(said.err.find(GetParam().says), std::string::npos) << said.err;
  EXPECT_EQ(slurp(file("keep.csv")), "kept\n");
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, BadInput,
    testing::Values(
        Bad{"", ""}, Bad{"draw", "draw"}, Bad{"list --major 3", "--major"}, Bad{"line", "--major"},
        Bad{"line --major 5", "--minor"}, Bad{"line --major 5 --minor 9 --csv keep.csv", "--minor"},
        Bad{"line --major 1e999 --minor 0", "--major"},
        Bad{"line --major nan --minor 0", "--major"}, Bad{"line --major -1 --minor 0", "--major"},
        Bad{"line --major '' --minor 0", "--major"},
        Bad{"line --major 4294967296 --minor 0", "--major"},
        Bad{"line --major 5 --minor 1.5", "--minor"}, Bad{"line --major 5 --minor 1 --m 7", "M=7"},
        Bad{"line --major 5 --minor 1 --m 33", "--m"}, Bad{"line --major 5 --minor 1 --n 0", "--n"},
        Bad{"line --major 300 --minor 1 --m 8", "300"},
        Bad{"line --major 27 --minor 9 --code 0101x", "--code"},
        Bad{"line --major 27 --minor 9 --code 32 --m 5", "--code"},
        Bad{"line --major 27 --minor 8 --code 01010", "--code"},
        Bad{"line --major 5 --minor 1 --seed -3", "--seed"},
        Bad{"line --major 5 --minor 1 --csv /dev/full", "/dev/full"},
        Bad{"line --major 5 --minor 1 --csv no/such/folder", "no/such/folder"},
        Bad{"line --major 5 --minor 1 --report no/such/folder", "no/such/folder"},
        Bad{"line --major 5 --minor 1 --csv keep.csv --report keep.csv", "keep.csv"},
        Bad{"arc", "--radius"}, Bad{"arc --radius 5 --radius2 25", "--radius"},
        Bad{"arc --radius nan", "--radius"}, Bad{"arc --radius 4294967296", "--radius"},
        Bad{"arc --radius 5 --from 3", "--from"}, Bad{"arc --radius 5 --from 3,4,5", "--from"},
        Bad{"arc --radius 5 --from 3,3 --csv keep.csv", "(3, 3)"},
        Bad{"arc --radius 5 --from -3,4", "--from"}, Bad{"arc --radius 5 --count -1", "--count"},
        Bad{"arc --radius 5 --width 7", "W=7"}, Bad{"arc --radius 5 --width 99", "--width"},
        Bad{"arc --radius 300 --width 8", "circular"}, Bad{"path --steps-per-mm 1", "FILE"},
        Bad{"path still.ngc", "--steps-per-mm"},
        Bad{"path still.ngc --steps-per-mm 0", "--steps-per-mm"},
        Bad{"path still.ngc --steps-per-mm inf", "--steps-per-mm"},
        Bad{"path still.ngc --steps-per-mm 1e999", "--steps-per-mm"},
        Bad{"path none.ngc --steps-per-mm 1", "none.ngc"}, Bad{"path . --steps-per-mm 1", "."},
        Bad{"path empty.ngc --steps-per-mm 1", "empty.ngc"},
        Bad{"path still.ngc --steps-per-mm 1 --csv keep.csv", "still.ngc"},
        Bad{"path binary.ngc --steps-per-mm 1", "binary.ngc:1:6"},
        Bad{"path radius.ngc --steps-per-mm 1 --csv keep.csv", "radius.ngc:3:4"},
        Bad{"path offset.ngc --steps-per-mm 1", "offset.ngc:2:3"},
        Bad{"path huge.ngc --steps-per-mm 1", "huge.ngc:1:6"},
        Bad{"path nan.ngc --steps-per-mm 1", "nan.ngc:1:4"},
        Bad{"path far.ngc --steps-per-mm 100", "far.ngc:1:4"}, Bad{"sweep", ""},
        Bad{"sweep spiral --random 5", "spiral"}, Bad{"sweep linear", "--exhaustive"},
        Bad{"sweep linear --random 5 --hostile 5", "--random"},
        Bad{"sweep linear --random 0", "--random"},
        Bad{"sweep linear --random 5 --jobs 0", "--jobs"},
        Bad{"sweep linear --hostile 5 --lanes 128", "--lanes"},
        Bad{"sweep circular --exhaustive --width 16", "--exhaustive"}),
    [](const auto& test) { return "N" + std::to_string(test.index); });

}  // namespace
}  // namespace cosim::test

// Casts to a size that yosys misreads.
#include "tb/equiv/front_end.h"

#include <gtest/gtest.h>

namespace cosim::equiv {
namespace {

TEST(Casts, HaveBracketsBehindAnOperator) {
  EXPECT_EQ(with_casts_apart("a = |5'(b);"), "a = |(5'(b));");
  EXPECT_EQ(with_casts_apart("~ W ' (b[(c)]) + -(W + 1)'(2'(d))"),
            "~ (W ' (b[(c)])) + -((W + 1)'(2'(d)))");
  EXPECT_EQ(with_casts_apart("!p::W'(-3'(a))"), "!(p::W'(-(3'(a))))");
}

TEST(Casts, LeaveAllElse) {
  for (const char* kept : {"a = 5'(b);", "|5'b1", "a ? 5'(b) : 4'(c)", "'{a, -1'b1}", "// |5'(b)\n",
                           "/* |5'(b) */", "\"|5'(b)\"", "(5'(b))", "'", "|'"}) {
    EXPECT_EQ(with_casts_apart(kept), kept);
  }
}

}  // namespace
}  // namespace cosim::equiv

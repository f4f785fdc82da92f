// cosim equiv: RTL of several clocks.
#include <gtest/gtest.h>

#include "tests/cli/equiv_pairs.h"

namespace cosim::cli {
namespace {

// `d` through a register of clock a to one of clock b.
std::string crossing(const std::string& a, const std::string& b, const std::string& q) {
  return "module m(input a, b, rst, input [1:0] d, output [1:0] q);\nreg [1:0] p, r; assign q = r;"
         "always @(" +
         a + ") if (rst) p <= 0; else p <= d;\nalways @(" + b +
         ") if (rst) r <= 0; else r <= " + q + ";\nendmodule\n";
}

TEST(EquivClocks, AnyOfThemHasItsEdge) {
  const std::string one = crossing("posedge a", "negedge b", "~p");
  expect_equal(one, crossing("posedge a", "negedge b", "p ^ 2'd3"));
  // Whose registers are others: the second one holds what is inverted behind it.
  expect_equal(
      crossing("posedge a", "posedge b", "p"),
      "module m(input a, b, rst, input [1:0] d, output [1:0] q);\nreg [1:0] x, y; assign q "
      "= ~y; always @(posedge a) x <= rst ? 3 : ~d;\nalways @(posedge b) y <= rst ? 3 : x;"
      "\nendmodule\n");
  expect_different(one, crossing("posedge a", "negedge b", "p == 3 ? 1 : ~p"), "q is ");
  // Only where b has its edge and a has none are these two.
  expect_different(one, crossing("posedge a", "negedge b", "~d"), "q is ");
  expect_different(crossing("posedge a", "posedge b", "p"), crossing("posedge b", "posedge b", "p"),
                   "q is ");
}

// A register without an initial value is what the reset makes it.
TEST(EquivClocks, AllHaveTheirEdgesWhileItResets) {
  expect_equal(
      "module m(input a, b, rst, input [1:0] d, output [1:0] q);\nreg [1:0] x = 0, y = 0; assign q "
      "= y; always @(posedge a) x <= rst ? 0 : d;\nalways @(posedge b) y <= rst ? 0 : x;"
      "\nendmodule\n",
      crossing("posedge a", "posedge b", "p"));
}

// Each has one.
TEST(EquivClocks, AnotherClockIsNotTheSame) {
  const auto rtl = [](const std::string& clock) {
    return "module m(input a, b, d, output reg q); always @(posedge " + clock +
           ") q <= d; endmodule\n";
  };
  expect_equal(rtl("a"), rtl("a") + "// moved\n");
  expect_different(rtl("a"), rtl("b"), "clocks that have their edges on any steps");
  // But a port of another name is.
  const std::string renamed =
      "module m(input c, b, d, output reg q); wire e = d; always @(posedge c) q <= e & d; "
      "endmodule\n";
  expect_equal(rtl("a"), renamed);
}

TEST(EquivClocks, WithAnAsynchronousResetAndAMemory) {
  const auto rtl = [](const std::string& first, const std::string& count) {
    return "module m(input w, r, rst_n, input d, output reg q);\nreg [1:0] n; reg s[0:3];\n"
           "always @(posedge w or negedge rst_n) if (!rst_n) n <= " +
           first + "; else n <= " + count +
           ";\nalways @(posedge w) s[n] <= d;\nalways @(posedge r) q <= s[n];\nendmodule\n";
  };
  expect_equal(rtl("1", "n + 1"), rtl("1", "{n[1] ^ n[0], ~n[0]}"));
  expect_different(rtl("1", "n + 1"), rtl("1", "{n[1], ~n[0]}"), "q is ");
  // One that gets the same from the same clock.
  const auto gated = [](const std::string& clock, const std::string& d) {
    return "module m(input w, r, a, e, d, output reg q);\nreg p; reg s[0:1];\nalways @(posedge w) "
           "p "
           "<= d;\nalways @(posedge " +
           clock + ") if (e) s[a] <= " + d + ";\nalways @(posedge r) q <= s[~a];\nendmodule\n";
  };
  expect_said(0, gated("w", "p ^ d"), gated("w", "p & ~d | ~p & d"), "memories that get the same");
  expect_different(gated("w", "p"), gated("r", "p"), "q is ");
  expect_different(gated("w", "p"), gated("w", "p & d"), "q is ");
}

TEST(EquivClocks, WhatHasNoMeaningIsRefused) {
  const std::string one = crossing("posedge a", "posedge b", "p");
  expect_refused(equiv(one, crossing("posedge a", "negedge b", "p")),
                 "b: one takes over when it rises, the other when it falls");
  expect_refused(equiv(one, crossing("posedge a", "posedge b", "p & a")),
                 "a: is read as data, and there are several clocks");
  expect_refused(equiv(one, crossing("posedge a", "posedge b", "p & d"), {"--latency", "1"}),
                 "--latency: there are several clocks");
  expect_refused(equiv(one, one, {"--reset", "a"}), "--reset: 'a' is a clock");
}

TEST(EquivReplay, OfSeveralClocks) {
  expect_said(1, crossing("posedge a", "negedge b", "p"), crossing("posedge a", "negedge b", "d"),
              "replayed in Verilator");
}

}  // namespace
}  // namespace cosim::cli

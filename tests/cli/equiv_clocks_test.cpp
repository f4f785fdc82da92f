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

TEST(EquivClocks, WhatHasNoMeaningIsRefused) {
  const std::string one = crossing("posedge a", "posedge b", "p");
  expect_refused(equiv(one, crossing("posedge a", "negedge b", "p")),
                 "clock b: the old RTL uses the rising edge, the new RTL the falling edge");
  expect_refused(equiv(one, crossing("posedge a", "posedge b", "p & a")),
                 "a: is read as data, and there are several clocks");
  expect_refused(equiv(one, crossing("posedge a", "posedge b", "p & d"), {"--latency", "1"}),
                 "--latency: there are several clocks");
  expect_refused(equiv(one, one, {"--reset", "a"}), "--reset: 'a' is a clock");
}

}  // namespace
}  // namespace cosim::cli

// What yosys writes of a machine for SMT-LIB 2, read.
#include "tb/proof/rtl.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace cosim::proof {
namespace {

// Two registers and two inputs, of which one is read as a bit and one as a condition; and wires.
std::string machine(const std::vector<std::string>& wires) {
  std::string text =
      "(declare-fun |top#0| (|top_s|) (_ BitVec 4)) ; held\n"
      "(declare-fun |top#1| (|top_s|) Bool) ; odd\n"
      "(declare-fun |top#2| (|top_s|) (_ BitVec 1)) ; \\rst_n\n"
      "(declare-fun |top#3| (|top_s|) Bool) ; \\rst\n";
  for (std::size_t i = 0; i < wires.size(); ++i) {
    const char* sort = wires[i].find("#1|") == std::string::npos ? "(_ BitVec 4)" : "Bool";
    text += fmt::format(
        "(define-fun |top#{0}| ((state |top_s|)) {1} {2}) ; \\w\n"
        "(define-fun |top_n w{3}| ((state |top_s|)) {1} (|top#{0}| state))\n",
        i + 4, sort, wires[i], i);
  }
  return text;
}

TEST(Rtl, SeesARegisterThroughItsReset) {
  const std::string low = "(= ((_ extract 0 0) (|top#2| state)) #b1)", high = "(|top#3| state)";
  const std::string held = "(|top#0| state)", odd = "(|top#1| state)";
  const std::vector<std::pair<std::string, std::vector<std::size_t>>> wires = {
      {fmt::format("(ite {} {} #b0001)", low, held), {0}},
      {fmt::format("(ite {} #b0001 {})", high, held), {0}},
      {fmt::format("(ite {} {} true)", low, odd), {1}},
      {fmt::format("(ite {} false {})", high, odd), {1}},
      {fmt::format("(ite {} #b0001 #b0000)", high), {}},
      {fmt::format("(ite {} {} {})", high, held, held), {}},
      {fmt::format("(ite (not {}) #b0001 {})", odd, held), {}},
  };
  std::vector<std::string> bodies;
  for (const auto& [body, pieces] : wires) bodies.push_back(body);
  const Rtl plain("top", machine(bodies)), asynchronous("top", machine(bodies), true);
  for (std::size_t i = 0; i < wires.size(); ++i) {
    const std::string name = fmt::format("w{}", i);
    EXPECT_EQ(asynchronous.pieces(name), wires[i].second) << bodies[i];
    EXPECT_EQ(plain.pieces(name), std::vector<std::size_t>{}) << bodies[i];
  }
}

}  // namespace
}  // namespace cosim::proof

// Files of BTOR2 as they are read, how many gates come of them, and what is said of others.
#include "tb/nets/btor2.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tb/nets/number.h"
#include "tests/support/error_of.h"

namespace cosim::nets {
namespace {

TEST(Btor2, IsReadInItsOrder) {
  const Btor2 model = read_btor2(
      "; model counter, 2 ways through its clock\n"
      "1 sort bitvec 6\n\n"
      "2 sort bitvec 1 ; the second\n"
      "4 input 2 head.rst\n"
      "7 input 1 by\n"
      "8 state 1 store[3]\n"
      "9 state 2 on\n"
      "10 state 1 low\n"
      "20 state 1 high\n"
      "11 constd 1 -3 minus_three\n"
      "12 one 2\n"
      "21 constd 1 51\n"
      "13 init 1 8 11\n"
      "14 init 2 9 -12\n"
      "22 init 1 20 21\n"
      "15 add 1 7 -8\n"
      "16 next 1 8 15\n"
      "17 next 2 9 -9\n"
      "18 next 1 10 10\n"
      "23 next 1 20 7\n"
      "19 output -15 total\n"
      "24 output 9 on\n",
      "counter.btor2");
  const auto names = [](const std::vector<Btor2::Name>& all) {
    std::string text;
    for (const Btor2::Name& one : all) text += fmt::format("{}:{} ", one.name, one.width);
    return text;
  };
  EXPECT_EQ(names(model.inputs), "head.rst:1 by:6 ");
  EXPECT_EQ(names(model.states), "store[3]:6 on:1 low:6 high:6 ");
  EXPECT_EQ(names(model.outputs), "total:6 on:1 ");
  ASSERT_EQ(model.init.size(), 4U);
  EXPECT_EQ(model.init[0], (std::vector<bool>{true, false, true, true, true, true}));
  EXPECT_EQ(model.init[1], std::vector<bool>{false});
  EXPECT_FALSE(model.init[2].has_value());
  EXPECT_EQ(model.init[3], (std::vector<bool>{true, true, false, false, true, true}));

  Graph graph;
  const auto word = [&](const Btor2::Name& name) {
    Bits bits;
    for (int i = 0; i < name.width; ++i) bits.push_back(graph.input());
    return bits;
  };
  std::vector<Bits> inputs, states;
  for (const Btor2::Name& input : model.inputs) inputs.push_back(word(input));
  for (const Btor2::Name& state : model.states) states.push_back(word(state));
  const Clocked clocked = placed(graph, model, inputs, states);
  ASSERT_EQ(clocked.next.size(), 4U);
  EXPECT_EQ(clocked.next[1], Bits{!states[1][0]});
  EXPECT_EQ(clocked.next[2], states[2]);
  EXPECT_EQ(clocked.next[3], inputs[1]);
  EXPECT_EQ(clocked.outputs[1], states[1]);
  EXPECT_EQ(clocked.outputs[0][5], !clocked.next[0][5]);
}

// How many gates the one output comes to, where x, y and s have 64, 64 and 8 bits, and b has 1.
std::size_t gates_of(const std::string& lines) {
  const Btor2 model = read_btor2(
      "1 sort bitvec 64\n2 sort bitvec 8\n3 sort bitvec 1\n"
      "4 input 1 x\n5 input 1 y\n6 input 2 s\n7 input 3 b\n" +
          lines,
      "x.btor2");
  Graph graph;
  std::vector<Bits> inputs;
  for (const Btor2::Name& input : model.inputs) {
    Bits& word = inputs.emplace_back();
    for (int i = 0; i < input.width; ++i) word.push_back(graph.input());
  }
  const std::size_t before = graph.gates().size();
  placed(graph, model, inputs, {});
  return graph.gates().size() - before;
}
TEST(Btor2, ComesToFewGates) {
  // A full adder is two exclusive ors and a multiplexer; the first and the last one are less.
  EXPECT_EQ(gates_of("8 add 1 4 5\n9 output 8 o\n"), 64U * 3 - 2);
  EXPECT_EQ(gates_of("8 ult 3 4 5\n9 output 8 o\n"), 64U * 2);
  EXPECT_EQ(gates_of("8 ite 1 7 4 5\n9 output 8 o\n"), 64U);
  EXPECT_EQ(gates_of("8 eq 3 4 5\n9 output 8 o\n"), 64U * 2 - 1);
  // What was widened adds its own bits.
  const std::string widened = "8 sext 1 6 56\n9 slice 2 4 7 0\n10 sext 1 9 56\n";
  EXPECT_EQ(gates_of(widened + "11 add 1 8 10\n12 output 11 o\n"), 9U * 3 - 3);
  EXPECT_EQ(gates_of(widened + "11 slt 3 8 10\n12 output 11 o\n"), 8U * 2);
  Graph graph;
  Bits a, b;
  for (Bits* word : {&a, &b}) {
    for (int i = 0; i < 8; ++i) word->push_back(graph.input());
  }
  const Number product = Number::signed_code(graph, a) * Number::signed_code(graph, b);
  const std::vector<bool> cone = graph.cone(product.code(16));
  const auto of_numbers = static_cast<std::size_t>(std::ranges::count(cone, true)) - 16;
  EXPECT_LE(gates_of(widened + "11 mul 1 8 10\n12 output 11 o\n"), of_numbers);
  // A shift by a constant has no gates; one by 8 bits has six steps, and two that leave nothing.
  EXPECT_EQ(gates_of("8 constd 1 9\n9 sra 1 4 8\n10 output 9 o\n"), 0U);
  EXPECT_EQ(gates_of("8 uext 1 6 56\n9 srl 1 4 8\n10 output 9 o\n"), 64U * 6 + 1 + 64U);
  // What nothing reads is not made.
  EXPECT_EQ(gates_of("8 mul 1 4 5\n9 output 7 o\n"), 0U);
}

TEST(Btor2, MayBeDeep) {
  std::string text = "1 sort bitvec 1\n2 input 1 a\n3 input 1 b\n4 and 1 2 3\n";
  constexpr int last = 100'000;
  for (int i = 5; i <= last; ++i)
    text += fmt::format("{} {} 1 -{} {}\n", i, i % 2 == 0 ? "and" : "xor", i - 1, 2 + i % 2);
  text += fmt::format("{} output {} o\n", last + 1, last);
  const Btor2 model = read_btor2(text, "deep.btor2");
  Graph graph;
  const std::vector<Bits> inputs{{graph.input()}, {graph.input()}};
  EXPECT_EQ(placed(graph, model, inputs, {}).outputs.at(0).size(), 1U);
}

// What is said of these lines behind a sort of 8 bits, one of 1 bit, an input and a state.
std::string said_of(const std::string& lines) {
  const std::string before = "1 sort bitvec 8\n2 sort bitvec 1\n3 input 1 a\n4 state 1 s\n";
  return test::error_of([&] { read_btor2(before + lines, "x.btor2"); });
}
TEST(Btor2, ThatIsNotSupportedIsRefused) {
  EXPECT_EQ(said_of("5 next 1 4 3\n"), "");
  EXPECT_EQ(said_of("5 bad 3\n"), "x.btor2:5: 'bad' is not supported in a golden model");
  EXPECT_EQ(said_of("\n5 constraint 3\n"),
            "x.btor2:6: 'constraint' is not supported in a golden model");
  EXPECT_EQ(said_of("5 sort array 1 1\n"), "x.btor2:5: sort 'array' is not supported, only bitvec");
  EXPECT_EQ(said_of("5 sort bitvec 4097\n"),
            "x.btor2:5: the width is '4097', not a number from 1 to 4096");
  EXPECT_EQ(said_of("5 sort bitvec\n"), "x.btor2:5: the width is missing at the end of the line");
  EXPECT_EQ(said_of("a sort\n"),
            "x.btor2:5: the line's number is 'a', not a number from 1 to 2000000000");
  EXPECT_EQ(said_of("3 not 1 3\n"), "x.btor2:5: a second line has the number 3");
  EXPECT_EQ(said_of("5 not 3 3\n"), "x.btor2:5: 3 is not the number of a sort");
  EXPECT_EQ(said_of("5 not 1 -1\n"), "x.btor2:5: -1 is not the number of a value above");
  EXPECT_EQ(said_of("5 not 1 5\n"), "x.btor2:5: 5 is not the number of a value above");
  EXPECT_EQ(said_of("5 add 1 3\n"), "x.btor2:5: the operand is missing at the end of the line");
  EXPECT_EQ(said_of("5 not 1 3 name more\n"), "x.btor2:5: 'more' is one word too many");
  EXPECT_EQ(said_of("5 input 1\n"), "x.btor2:5: the name is missing at the end of the line");
  EXPECT_EQ(said_of("5 input 2 a\n"), "x.btor2:5: a second input is named 'a'");
  EXPECT_EQ(said_of("5 state 2 a\n6 next 2 5 5\n"), "x.btor2:4: state 's' has no next value");
  EXPECT_EQ(said_of("5 init 1 4 3\n"), "x.btor2:5: init: 3 is not a constant");
  EXPECT_EQ(said_of("5 next 1 3 4\n"), "x.btor2:5: next: 3 is not a state");
  EXPECT_EQ(said_of("5 next 1 4 4\n6 next 1 4 4\n"), "x.btor2:6: a second next of state 's'");
  EXPECT_EQ(said_of("5 one 1\n6 init 1 4 5\n7 init 1 4 5\n"),
            "x.btor2:7: a second init of state 's'");
  EXPECT_EQ(said_of("5 one 2\n6 init 1 4 5\n"),
            "x.btor2:6: init of 8 bits: state 's' has 8, its value 1");
}
TEST(Btor2, WidthsThatDoNotFitAreRefused) {
  const auto unfit = [](const std::string& kind, int width, const std::string& of) {
    return fmt::format("x.btor2:6: {} of {}: the widths of its operands, {}, do not fit", kind,
                       width == 1 ? "1 bit" : fmt::format("{} bits", width), of);
  };
  const auto with_b = [](const std::string& line) { return said_of("5 input 2 b\n" + line); };
  EXPECT_EQ(with_b("6 not 2 3\n"), unfit("not", 1, "8"));
  EXPECT_EQ(with_b("6 add 1 3 5\n"), unfit("add", 8, "8, 1"));
  EXPECT_EQ(with_b("6 eq 1 3 3\n"), unfit("eq", 8, "8, 8"));
  EXPECT_EQ(with_b("6 ult 2 3 5\n"), unfit("ult", 1, "8, 1"));
  EXPECT_EQ(with_b("6 ite 1 3 3 3\n"), unfit("ite", 8, "8, 8, 8"));
  EXPECT_EQ(with_b("6 concat 1 3 5\n"), unfit("concat", 8, "8, 1"));
  EXPECT_EQ(with_b("6 uext 1 5 6\n"), unfit("uext", 8, "1"));
  EXPECT_EQ(with_b("6 slice 2 3 4 3\n"), unfit("slice", 1, "8"));
  EXPECT_EQ(with_b("6 slice 2 3 8 8\n"),
            "x.btor2:6: the highest bit is '8', not a number from 0 to 7");
  EXPECT_EQ(with_b("6 slice 2 3 4 5\n"),
            "x.btor2:6: the lowest bit is '5', not a number from 0 to 4");
}
TEST(Btor2, ConstantsThatDoNotFitAreRefused) {
  const std::string accepted =
      "5 constd 1 -128\n6 constd 1 255\n7 const 1 011111111\n8 consth 1 0Fa\n9 constd 1 -0\n"
      "10 next 1 4 9\n";
  EXPECT_EQ(said_of(accepted), "");
  const auto unfit = [](const std::string& kind, const std::string& value) {
    const std::string base = kind == "const" ? "2" : kind == "constd" ? "10" : "16";
    EXPECT_EQ(
        said_of(fmt::format("5 {} 1 {}\n", kind, value)),
        fmt::format("x.btor2:5: '{}' is not a number of base {} that fits 8 bits", value, base));
  };
  unfit("const", "100000000");
  unfit("const", "2");
  unfit("constd", "256");
  unfit("constd", "-129");
  unfit("constd", "-");
  unfit("consth", "100");
  unfit("consth", "-1");
  unfit("consth", "g");
}

}  // namespace
}  // namespace cosim::nets

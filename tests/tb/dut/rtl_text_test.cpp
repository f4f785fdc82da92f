// What the RTL's text says of registers and resets, against what a design says.
#include <gtest/gtest.h>

#include <functional>

#include "model/core/input_error.h"
#include "tb/dut/registers.h"

namespace cosim {
namespace {

using Names = std::vector<std::string>;

Field field(const char* net) {
  Field f{};
  f.name = net;
  f.net = net;
  return f;
}

std::string said(const std::function<void()>& run) {
  try {
    run();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// `store` is a memory; sub.held goes by the name `top` as well.
const RtlText text{"made W=4", "count\nstore\nsub.held sub.out top\ndebug.a\ndebug.b.c", ""};

TEST(Unobserved, IsWhatPatternsAllowAndNoFieldNames) {
  EXPECT_EQ(
      unobserved_registers(text, {field("count"), field("store[3]"), field("top")}, {"debug.*"}),
      (Names{"debug.a", "debug.b.c"}));
  EXPECT_EQ(
      unobserved_registers(text, {field("count"), field("top")}, {"*.a", "st*re", "debug.b.c"}),
      (Names{"store", "debug.a", "debug.b.c"}));
}

TEST(Unobserved, EveryOtherRegisterIsRefused) {
  EXPECT_EQ(said([] {
              unobserved_registers(text, {field("count"), field("store")}, {"debug.*"});
            }),
            "made W=4: the RTL has a register sub.held that no table names and that is not in "
            "unobserved");
}

TEST(Unobserved, SoIsAMemoryOfSeveralDimensions) {
  const RtlText deep{"made", "count\ngrid[][]", ""};
  EXPECT_EQ(unobserved_registers(deep, {field("count")}, {"grid"}), Names{"grid"});
  for (const char* net : {"grid", "grid[2]"}) {
    EXPECT_EQ(
        said([&] {
          unobserved_registers(deep, {field("count"), field(net)}, {});
        }),
        "made: register grid: a memory of more dimensions than one can only be in unobserved");
  }
}

TEST(Unobserved, APatternThatNamesNothingIsRefused) {
  const std::vector<Field> fields{field("count"), field("store"), field("top")};
  for (const char* pattern : {"debug", "debug.x*", "count", "*.d"}) {
    EXPECT_EQ(said([&] {
                unobserved_registers(text, fields, {"debug.*", pattern});
              }),
              std::string("made W=4: unobserved has ") + pattern +
                  ", and the RTL has no such register beside the tables");
  }
}

TEST(Unobserved, NothingIsKnownWithoutTheText) {
  EXPECT_EQ(unobserved_registers({"made", "", ""}, {}, {"debug.*"}), Names{});
}

TEST(Resets, AreThoseThatTheDesignNames) {
  const RtlText none{"made", "q", ""}, high{"made", "q", "rst"}, low{"made", "q", "low rst_n"};
  const auto at_edge = Resets::at_edge, at_once = Resets::at_once, each = Resets::each_at_once;
  EXPECT_EQ(said([&] { require_resets(none, at_edge, {{"rst", true}}); }), "");
  EXPECT_EQ(said([&] { require_resets(high, at_once, {{"rst", true}}); }), "");
  EXPECT_EQ(said([&] { require_resets(low, at_once, {{"rst_n", false}}); }), "");
  EXPECT_EQ(said([&] { require_resets(low, each, {{"rst_n", false}, {"x", true}}); }), "");
  const std::string no_register = ", and no register of the RTL has an asynchronous reset";
  EXPECT_EQ(said([&] {
              require_resets(none, at_once, {{"rst", true}});
            }),
            "made: asynchronous_reset" + no_register);
  EXPECT_EQ(said([&] {
              require_resets(none, each, {{"rst", true}});
            }),
            "made: reset()" + no_register);
  EXPECT_EQ(said([&] {
              require_resets(low, at_edge, {{"rst_n", false}});
            }),
            "made: rst_n resets asynchronously: struct Design is to say asynchronous_reset = true");
  for (const std::vector<ResetPin>& pins : {std::vector<ResetPin>{{"rst_n", true}},
                                            {{"other", false}},
                                            {{"rst_n", false}, {"x", true}}}) {
    EXPECT_EQ(said([&] { require_resets(low, at_once, pins); }),
              "made: rst_n resets asynchronously where it is 0, and clear() is to differ from "
              "rest() in that alone");
  }
}

TEST(Resets, OfSeveralAreGivenByTheClearTogether) {
  const RtlText two{"made", "q", "a\nlow b"};
  const ResetPin a{"a", true}, b{"b", false}, b_high{"b", true}, x{"x", true};
  EXPECT_EQ(said([&] { require_resets(two, Resets::each_at_once, {a, b}); }), "");
  EXPECT_EQ(said([&] { require_resets(two, Resets::each_at_once, {x, b, a}); }), "");
  for (const std::vector<ResetPin>& pins :
       {std::vector<ResetPin>{a}, {a, x}, std::vector<ResetPin>{a, b_high}}) {
    EXPECT_EQ(said([&] { require_resets(two, Resets::each_at_once, pins); }),
              "made: b resets asynchronously where it is 0, and clear() is to give it");
  }
  for (const Resets design : {Resets::at_edge, Resets::at_once}) {
    EXPECT_EQ(
        said([&] {
          require_resets(two, design, {a, b});
        }),
        "made: a and b reset asynchronously: the model is to say what each clears, with reset()");
  }
}

}  // namespace
}  // namespace cosim

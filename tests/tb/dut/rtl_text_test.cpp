// What the RTL's text says of registers and resets, against what a design says.
#include <gtest/gtest.h>

#include "tb/dut/registers.h"
#include "tests/support/error_of.h"

namespace cosim {
namespace {

using Names = std::vector<std::string>;

Field field(const char* net, int width = 4) {
  Field f{};
  f.name = net;
  f.net = net;
  f.width = width;
  f.index = -1;
  return f;
}

// `store` is a memory; sub.held goes by the name `top` as well.
const RtlText kText{"made W=4",
                    "count 4 0 3:0\nstore 4 4 15:0\nsub.held 4 0 3:0 sub.out 4 0 0 top 8 0 2\n"
                    "debug.a 1 0 0:0\ndebug.b.c 2 0 1:0",
                    ""};
const Field store[] = {field("store[0]"), field("store[1]"), field("store[2]"), field("store[3]")};
// The whole store behind these.
std::vector<Field> with_store(std::vector<Field> fields) {
  fields.insert(fields.end(), std::begin(store), std::end(store));
  return fields;
}

TEST(Unobserved, IsWhatPatternsAllowAndNoFieldNames) {
  EXPECT_EQ(unobserved_signals(kText, with_store({field("count"), field("top[5:2]")}), {"debug.*"}),
            (Names{"debug.a", "debug.b.c"}));
  EXPECT_EQ(
      unobserved_signals(kText, {field("count"), field("top", 8)}, {"*.a", "st*re", "debug.b.c"}),
      (Names{"store", "debug.a", "debug.b.c"}));
}

// What is said of fields in the tables and patterns in unobserved.
template <class... More>
std::string said_of(const RtlText& rtl, const std::vector<Field>& fields,
                    const std::vector<std::string>& patterns, const More&... more) {
  return test::error_of([&] { unobserved_signals(rtl, fields, patterns, more...); });
}
std::string refused(const std::vector<Field>& fields) {
  return said_of(kText, fields, {"debug.*"});
}
std::string escapes(const std::string& part) {
  return "made W=4: the RTL has a register " + part +
         " that is neither in the model nor in unobserved";
}

TEST(Unobserved, EveryOtherRegisterIsRefused) {
  EXPECT_EQ(refused(with_store({field("count")})), escapes("sub.held"));
}

TEST(Unobserved, AllThatAreRefusedAreSaidAtOnce) {
  EXPECT_EQ(refused({field("count[3:1]", 3)}),
            "made W=4: the RTL has registers that are neither in the model nor in unobserved: "
            "count[0], store, sub.held");
}

TEST(Unobserved, SoIsEveryOtherBit) {
  const Field held = field("sub.held");
  const auto all_but = [&](std::vector<Field> fields) {
    fields.push_back(held);
    return refused(with_store(fields));
  };
  EXPECT_EQ(all_but({field("count[2:0]", 3)}), escapes("count[3]"));
  EXPECT_EQ(all_but({field("count[3:2]", 2)}), escapes("count[1:0]"));
  EXPECT_EQ(all_but({field("count[3]", 1), field("count[0]", 1)}), escapes("count[2:1]"));
  EXPECT_EQ(all_but({field("count[3:2]", 2), field("count[1:0]", 2)}), "");
  EXPECT_EQ(refused({field("count"), held, store[0]}), escapes("store[3:1]"));
  EXPECT_EQ(
      refused({field("count"), held, store[0], store[1], store[3], field("store[2][3:1]", 3)}),
      escapes("store[2][0]"));
  EXPECT_EQ(refused(with_store({field("count"), field("top[4:2]", 3)})), escapes("sub.held[3]"));
}

TEST(Unobserved, MayBeSomeBits) {
  const std::vector<Field> some{field("count[1:0]", 2), store[1], store[2], field("sub.out")};
  EXPECT_EQ(unobserved_signals(kText, some, {"debug.*", "count[3:2]", "store"}),
            (Names{"count[3:2]", "store[0]", "store[3]", "debug.a", "debug.b.c"}));
  EXPECT_EQ(said_of(kText, some, {"debug.*", "count[3:2]", "store[0]"}), escapes("store[3]"));
}

TEST(Unobserved, BitsThatHoldNoStateNeedNoField) {
  const RtlText part{"made", "mixed 8 0 7:4,0:0", ""};
  EXPECT_EQ(unobserved_signals(part, {field("mixed[7:4]"), field("mixed[0]", 1)}, {}), Names{});
  EXPECT_EQ(unobserved_signals(part, {field("mixed[7:4]")}, {"mixed"}), Names{"mixed[0]"});
}

TEST(Unobserved, SoIsAQueue) {
  const RtlText deep{"made", "count 4 0 3:0\ngrid 64 -1 63:0", ""};
  EXPECT_EQ(unobserved_signals(deep, {field("count")}, {"grid"}), Names{"grid"});
  for (const std::vector<Field>& fields :
       {std::vector<Field>{field("count")}, {field("count"), field("grid")}}) {
    const std::string refused = said_of(deep, fields, {});
    EXPECT_TRUE(refused.ends_with(
        "register grid: a queue or an associative array can only be in unobserved"))
        << refused;
  }
}

TEST(Unobserved, SoIsAnOutputThatNoRowNames) {
  const RtlText made{"made", "q 1 0 0:0", "", "q\nspare\nspared"};
  const std::vector<Field> spared{field("spared[3:0]")};
  EXPECT_EQ(unobserved_signals(made, {}, {"*"}, spared), (Names{"q", "spare"}));
  EXPECT_EQ(unobserved_signals(made, {field("q", 1)}, {"spare"}, spared), Names{"spare"});
  EXPECT_EQ(said_of(made, {}, {"q", "spared"}, spared),
            "made: unobserved has spared, and the RTL has no such register or output outside "
            "the model");
}

TEST(Unobserved, APatternThatNamesNothingIsRefused) {
  const std::vector<Field> fields = with_store({field("count"), field("top", 8)});
  for (const char* pattern : {"debug", "debug.x*", "count", "count[1:0]", "*.d"}) {
    EXPECT_EQ(said_of(kText, fields, {"debug.*", pattern}),
              std::string("made W=4: unobserved has ") + pattern +
                  ", and the RTL has no such register or output outside the model");
  }
}

// What is said of the resets of a design, and of its pins.
std::string said_of(const RtlText& rtl, Resets design, const std::vector<ResetPin>& pins) {
  return test::error_of([&] { require_resets(rtl, design, pins); });
}

TEST(Resets, AreThoseThatTheDesignNames) {
  const RtlText none{"made", "q", ""}, high{"made", "q", "rst"}, low{"made", "q", "low rst_n"};
  const auto at_edge = Resets::at_edge, at_once = Resets::at_once, each = Resets::each_at_once;
  const ResetPin rst{"rst", true}, rst_n{"rst_n", false}, x{"x", true};
  EXPECT_EQ(said_of(none, at_edge, {rst}), "");
  EXPECT_EQ(said_of(high, at_once, {rst}), "");
  EXPECT_EQ(said_of(low, at_once, {rst_n}), "");
  EXPECT_EQ(said_of(low, each, {rst_n, x}), "");
  const std::string no_register = ", and no register of the RTL has an asynchronous reset";
  EXPECT_EQ(said_of(none, at_once, {rst}), "made: asynchronous_reset" + no_register);
  EXPECT_EQ(said_of(none, each, {rst}), "made: reset_at_once()" + no_register);
  EXPECT_EQ(said_of(low, at_edge, {rst_n}),
            "made: rst_n resets asynchronously: the model must have asynchronous_reset = true");
  for (const std::vector<ResetPin>& pins :
       {std::vector<ResetPin>{{"rst_n", true}}, {{"other", false}}, {rst_n, x}}) {
    EXPECT_EQ(
        said_of(low, at_once, pins),
        "made: rst_n resets asynchronously while it is 0: the model's reset must name this pin "
        "alone");
  }
}

TEST(Resets, OfSeveralAreGivenTogether) {
  const RtlText two{"made", "q", "a\nlow b"};
  const ResetPin a{"a", true}, b{"b", false}, b_high{"b", true}, x{"x", true};
  EXPECT_EQ(said_of(two, Resets::each_at_once, {a, b}), "");
  EXPECT_EQ(said_of(two, Resets::each_at_once, {x, b, a}), "");
  for (const std::vector<ResetPin>& pins :
       {std::vector<ResetPin>{a}, {a, x}, std::vector<ResetPin>{a, b_high}}) {
    EXPECT_EQ(said_of(two, Resets::each_at_once, pins),
              "made: b resets asynchronously while it is 0: the model's reset must name this pin");
  }
  for (const Resets design : {Resets::at_edge, Resets::at_once}) {
    EXPECT_EQ(said_of(two, design, {a, b}),
              "made: a and b reset asynchronously: write what each clears in reset_at_once()");
  }
}

TEST(Unreset, RegistersAreFieldsOfTheState) {
  const RtlText made{"made", "a\nb", ""};
  const Field a{"a", 1, Format::bits, "", ""}, b{"b", 1, Format::bits, "", ""};
  Field unreset = b;
  unreset.unreset = true;
  const auto said_of = [&](const std::vector<Field>& registers, const std::vector<Field>& state) {
    return test::error_of([&] { require_taken_over(made, registers, state); });
  };
  EXPECT_EQ(said_of({a, b}, {a}), "");
  EXPECT_EQ(said_of({a, unreset}, {a, b}), "");
  EXPECT_EQ(
      said_of({a, unreset}, {a}),
      "made: b has no reset value, and the model has no member of that name to take its value "
      "over");
}

TEST(Resets, ByARegisterAreInReset) {
  for (const char* resets : {"inner ready", "low rst_n\ninner low ready"}) {
    const RtlText made{"made", "q", resets};
    const ResetPin rst_n{"rst_n", false};
    EXPECT_EQ(said_of(made, Resets::each_at_once, {rst_n}), "");
    for (const Resets design : {Resets::at_edge, Resets::at_once}) {
      EXPECT_EQ(said_of(made, design, {rst_n}),
                "made: register ready resets others asynchronously: write what it clears in "
                "reset_at_once()");
    }
  }
}

}  // namespace
}  // namespace cosim

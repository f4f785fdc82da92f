// A difference planted on purpose: the model in the RTL's place with a bit turned over from one
// clock on. What is reported of it, and how it reads.
// Needs: linear, circular
#include "tb/sim/mismatch.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "tests/designs/circular/records.h"
#include "tests/designs/linear/records.h"
#include "tests/support/model_adapter.h"

namespace cosim {
namespace {

/// Bit `bit` of signal `signal`, counting registers, then outputs, on the clocks first .. last.
struct Fault {
  std::uint64_t first;
  std::uint64_t last;
  std::size_t signal;
  int bit;
};

template <class D, typename D::Params P, Fault F>
class FaultyAdapter : public test::ModelAdapter<D, P> {
  using Base = test::ModelAdapter<D, P>;

 public:
  using Base::Base;
  void eval(bool clk) override {
    edges_ += clk;
    Base::eval(clk);
  }
  typename Base::Registers registers() const override { return turned(Base::registers(), 0); }
  typename Base::Outputs outputs() const override {
    return turned(Base::outputs(), Base::Registers::size);
  }

 private:
  template <class Record>
  Record turned(const Record& record, std::size_t base) const {
    auto words = to_words(record);
    const std::uint64_t clock = edges_ - 1;  // the first edge is the reset's
    if (clock >= F.first && clock <= F.last && F.signal >= base && F.signal - base < words.size()) {
      words[F.signal - base] ^= Word{1} << F.bit;
    }
    return from_words<Record>(words);
  }
  std::uint64_t edges_ = 0;
};

constexpr std::uint64_t kEver = ~std::uint64_t{0};
constexpr std::size_t kCt7 = 3, kCt8 = 4, kStepY = 6;  // t4 t16 f ct7 ct8 running step_y step_x

template <class D, typename D::Params P, Fault F>
DesignBench<D> faulty() {
  return DesignBench<D>(dut_maker<FaultyAdapter<D, P, F>>());
}

template <Fault F>
Mismatch drawn(const std::vector<circular::Arc>& arcs, std::uint64_t clocks) {
  const auto bench = faulty<circular::Design, circular::of_width(4), F>();
  Observers<circular::Design> nobody({});
  const auto run = bench.open(1)->draw(arcs, nobody);
  EXPECT_EQ(run.clocks, clocks);
  EXPECT_TRUE(run.mismatch);
  return run.mismatch.value_or(Mismatch{});
}

void expect_is(const Mismatch& m, std::uint64_t clock, const char* signal, Word expected,
               Word actual) {
  EXPECT_EQ(m.clock, clock);
  EXPECT_EQ(m.signal, signal);
  EXPECT_EQ(m.expected, expected);
  EXPECT_EQ(m.actual, actual);
}

const std::vector<circular::Arc> kR12 = {{{12, 0}, 144, {}}};  // 21 clocks

TEST(Mismatch, NamesClockSignalAndValues) {
  // Clock 0 loads; after four steps, on clock 5, CT7 is 4.
  const Mismatch m = drawn<Fault{5, kEver, kCt7, 1}>(kR12, 6);
  expect_is(m, 5, "ct7", 4, 6);
  EXPECT_STREQ(m.field.name, "ct7");
}

TEST(Mismatch, ShowsTheClocksAround) {
  const Mismatch m = drawn<Fault{10, kEver, kCt8, 0}>(kR12, 11);
  EXPECT_EQ(m.first, 2U);
  ASSERT_EQ(m.traces.size(), 8U + 5 + 3);
  const std::vector<std::string> names = {"rst",   "load",    "f",      "ct7",   "ct8", "sector2",
                                          "start", "stop",    "t4",     "t16",   "f",   "ct7",
                                          "ct8",   "running", "step_y", "step_x"};
  for (std::size_t i = 0; i < m.traces.size(); ++i) {
    EXPECT_EQ(m.traces[i].field.name, names[i]);
    EXPECT_EQ(m.traces[i].kind, i < 8    ? Trace::Kind::input
                                : i < 13 ? Trace::Kind::reg
                                         : Trace::Kind::output);
    EXPECT_EQ(m.traces[i].expected.size(), 8U + 1 + 4);
    EXPECT_EQ(m.traces[i].actual.size(), 8U + 1 + 4);
    EXPECT_EQ(m.traces[i].expected == m.traces[i].actual, i != 12) << i;
  }
  // Clocks 2 to 14: after the steps 1 to 9, the correction and 10 to 12, as the source prints them.
  const std::vector<Word> ct8 = {10, 9, 8, 6, 5, 3, 2, 0, -2, -1, -3, -4, -6};
  const Trace& t = m.traces[12];
  for (std::size_t c = 0; c < ct8.size(); ++c) {
    EXPECT_EQ(from_ones_complement(t.expected[c], 5), ct8[c]);
    EXPECT_EQ(t.actual[c], c < 8 ? t.expected[c] : t.expected[c] ^ 1);
  }
}

TEST(Mismatch, WindowEndsAtEitherEndOfTheRun) {
  const Mismatch early = drawn<Fault{0, 0, kStepY, 0}>(kR12, 1);
  ASSERT_FALSE(early.traces.empty());
  EXPECT_EQ(early.first, 0U);
  EXPECT_EQ(early.traces.front().expected.size(), 5U);  // clocks 0 to 4
  const Mismatch late = drawn<Fault{20, 20, kStepY, 0}>(kR12, 21);
  ASSERT_FALSE(late.traces.empty());
  EXPECT_EQ(late.first, 12U);
  EXPECT_EQ(late.traces.front().expected.size(), 9U);  // clocks 12 to 20
}

TEST(Mismatch, RegistersComeBeforeOutputs) {
  expect_is(drawn<Fault{9, kEver, kStepY, 0}>(kR12, 10), 9, "step_y", 1, 0);
}

TEST(Mismatch, CountsClocksFromTheSessionsStart) {
  const auto bench = faulty<circular::Design, circular::of_width(4), Fault{30, kEver, kCt7, 0}>();
  Observers<circular::Design> nobody({});
  const auto session = bench.open(1);
  EXPECT_FALSE(session->draw(kR12, nobody).mismatch);
  const auto second = session->draw(kR12, nobody);
  EXPECT_EQ(second.clocks, 30U - 21 + 1);
  ASSERT_TRUE(second.mismatch);
  // Clock 30 is the ninth after the second load: CT7 stands at 8.
  expect_is(*second.mismatch, 30, "ct7", 8, 9);
}

TEST(Mismatch, IsSeenUnderHostileClocks) {
  const auto bench = faulty<linear::Design, linear::of(5, 2), Fault{777, 777, 4, 2}>();
  const auto run = bench.run_hostile({1, 0, 1000});
  EXPECT_EQ(run.clocks, 778U);
  ASSERT_TRUE(run.mismatch);
  EXPECT_EQ(run.mismatch->clock, 777U);
  EXPECT_EQ(run.mismatch->signal, "register5");
  EXPECT_EQ(run.mismatch->expected ^ run.mismatch->actual, 0b100);
  EXPECT_EQ(run.mismatch->traces.front().expected.size(), 13U);
}

// Every bit of every register and output is compared.
template <std::size_t signal>
void expect_every_bit_seen() {
  const auto bench_with = []<int bit>() {
    const auto bench = faulty<circular::Design, circular::of_width(4), Fault{3, 3, signal, bit}>();
    const auto run = bench.run_hostile({1, 0, 10});
    EXPECT_EQ(run.clocks, 4U) << bench.compared()[signal].name << " bit " << bit;
    ASSERT_TRUE(run.mismatch);
    EXPECT_EQ(run.mismatch->signal, bench.compared()[signal].name);
    EXPECT_EQ(run.mismatch->expected ^ run.mismatch->actual, 1 << bit);
  };
  constexpr std::array<int, 8> widths = {1, 1, 8, 5, 5, 1, 1, 1};
  [&]<int... bit>(std::integer_sequence<int, bit...>) {
    (bench_with.template operator()<bit>(), ...);
  }
  (std::make_integer_sequence<int, widths[signal]>{});
}

TEST(Mismatch, IsSeenInEveryBitOfEverySignal) {
  [&]<std::size_t... signal>(std::index_sequence<signal...>) {
    (expect_every_bit_seen<signal>(), ...);
  }
  (std::make_index_sequence<8>{});
}

// The whole text, of a made-up difference.
TEST(MismatchText, IsATableOfTheClocksAround) {
  const Field enable{"enable", 1, Format::flag, "18", ""};
  const Field count{"count", 4, Format::number, "4", ""};
  const Field level{"level", 5, Format::ones_complement, "", ""};
  Mismatch m;
  m.clock = 100;
  m.first = 99;
  m.signal = "count";
  m.field = count;
  m.expected = 9;
  m.actual = 11;
  m.traces = {{enable, Trace::Kind::input, {1, 1, 0}, {1, 1, 0}},
              {count, Trace::Kind::reg, {8, 9, 10}, {8, 11, 10}},
              {level, Trace::Kind::output, {0b11111, 0b11110, 15}, {0b11111, 0b11110, 3}}};
  EXPECT_EQ(to_text(m),
            "first difference: clock 100, count, block 4\n"
            "  expected 1001 (9)\n"
            "  actual   1011 (11)\n"
            "  clock               99  >100  101\n"
            "  in  enable           1     1    0\n"
            "  reg count expected   8     9   10\n"
            "  reg count actual     8   11!   10\n"
            "  out level expected  -0    -1   15\n"
            "  out level actual    -0    -1   3!\n");
}

TEST(MismatchText, NamesNoBlockWhereThereIsNone) {
  Mismatch m;
  m.clock = 7;
  m.signal = "level";
  m.field = {"level", 5, Format::ones_complement, "", ""};
  m.expected = 1;
  m.actual = 0b11110;
  EXPECT_EQ(to_text(m).substr(0, to_text(m).find("  clock")),
            "first difference: clock 7, level\n"
            "  expected 00001 (1)\n"
            "  actual   11110 (-1)\n");
}

}  // namespace
}  // namespace cosim

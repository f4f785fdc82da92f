// The cycle model of SU 1665343 against the printed tables and the oracle.
#include <gtest/gtest.h>

#include "tests/designs/circular/counts.h"
#include "tests/designs/circular/printed.h"
#include "tests/designs/circular/shapes.h"
#include "tests/support/model_adapter.h"
#include "tests/support/model_machine.h"
#include "tests/support/reachable.h"

namespace cosim::circular {
namespace {

template <int width>
const CircularBench& model() {
  return test::model_bench<Design, of_width(width)>();
}

TEST(CircularModel, DrawsTheTables) {
  printed::expect_tables(model<4>());
  printed::expect_tables(model<16>());
  printed::expect_tables(model<32>());
}

// The codes of Table 2's counters, sign and four digits, at the least width that holds R = 12.
TEST(CircularModel, HoldsTheCodesOfTable2) {
  const auto codes = [](const Held& numbers) {
    return named<Held>(Design::registers(of_width(4), record_of<State<Word>>(numbers)));
  };
  const auto code8 = [&](Word ct8) { return codes({1, 0, 3, 0, ct8}).ct8; };
  EXPECT_EQ(code8(6), 0b00110);
  EXPECT_EQ(code8(-1), 0b11110);
  EXPECT_EQ(code8(-9), 0b10110);
  EXPECT_EQ(codes({1, 0, 3, 1, 0}).ct7, 0b00001);
  EXPECT_EQ(codes({1, 0, -49, 0, 0}).f, 0b11001110);  // -12.25 = -110001 / 4
}

TEST(CircularModelAgainstOracle, EveryRadius) { counted::expect_every_radius(model<12>(), 4095); }

TEST(CircularModelAgainstOracle, EveryStart) { counted::expect_every_start(model<8>(), 255); }

TEST(CircularModelAgainstOracle, EveryStop) { counted::expect_every_stop(model<8>(), 40); }

TEST(CircularModelAgainstOracle, EverySmallWidth) {
  counted::expect_every_start(model<2>(), 3);
  counted::expect_every_start(model<3>(), 7);
  counted::expect_every_start(model<4>(), 15);
}

TEST(CircularModelAgainstOracle, RandomArcs) {
  counted::expect_random_arcs(model<16>(), 1, 5000);
  counted::expect_random_arcs(model<24>(), 2, 5000);
  counted::expect_random_arcs(model<32>(), 3, 5000);
}

// On an arc with round(R) < 2^W no register wraps: every number is that of a far wider machine.
TEST(CircularModel, NeverWrapsOnAnArcOfItsWidth) {
  const auto expect_same = [](int width, std::span<const Arc> arcs) {
    const Params narrow = of_width(width), wide = of_width(32);
    HostOf<Design> narrow_host(narrow, arcs), wide_host(wide, arcs);
    test::ModelMachine<Design> narrow_machine(narrow), wide_machine(wide);
    Inputs<Word> narrow_in, wide_in;
    Outputs<Word> narrow_seen, wide_seen;
    while (wide_host.next(wide_in, wide_seen)) {
      ASSERT_TRUE(narrow_host.next(narrow_in, narrow_seen));
      narrow_seen = narrow_machine.clock(narrow_in);
      wide_seen = wide_machine.clock(wide_in);
      ASSERT_EQ(to_words(narrow_machine.state), to_words(wide_machine.state))
          << "width " << width << " R^2 " << arcs[wide_host.job()].radius2;
    }
  };
  for (int width = 2; width <= 6; ++width) {
    std::vector<Arc> arcs;
    const std::uint64_t below = std::uint64_t{1} << width;  // of round(R): R^2 <= (2^W - 1/2)^2
    for (std::uint64_t radius2 = 1; radius2 <= below * below - below; ++radius2) {
      for (const Point& start : every_start(radius2)) arcs.push_back({start, radius2, {}});
    }
    ASSERT_EQ(width_needed(arcs.back().radius2), width);
    expect_same(width, arcs);
    if (testing::Test::HasFatalFailure()) return;
  }
}

// Every number of the state comes back from its code.
void expect_recovered(const Params& p, const State<Word>& state) {
  const auto s = named<Held>(state), r = named<Held>(Design::registers(p, state));
  const int width = width_of(p);
  ASSERT_EQ(from_ones_complement(r.f, width + 4), s.f);
  ASSERT_EQ(from_ones_complement(r.ct7, width + 1), s.ct7);
  ASSERT_EQ(from_ones_complement(r.ct8, width + 1), s.ct8);
  ASSERT_NE(r.f, 0);                  // F has no +0
  ASSERT_NE(r.ct7, ones(width + 1));  // the counters have no -0
  ASSERT_NE(r.ct8, ones(width + 1));
}

TEST(CircularReachable, StatesFitTheRegisters) {
  test::expect_states_fit_the_registers<Design>(expect_recovered);
}

}  // namespace
}  // namespace cosim::circular

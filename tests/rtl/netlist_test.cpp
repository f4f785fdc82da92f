// Netlists in the testbench, in place of the RTL and behind its adapters: hostile clocks, and all
// the work there is at a small width.
#include <gtest/gtest.h>

#include "tb/designs/dda/sweeps.h"
#include "tests/designs/circular/counts.h"
#include "tests/designs/circular/printed.h"
#include "tests/designs/linear/counts.h"
#include "tests/designs/linear/printed.h"
#include "tests/rtl/variant.h"

namespace cosim {
namespace {

constexpr std::uint64_t kHostileClocks = 100'000;

/// The bench of the one netlist of a design; null where there is no yosys to make it.
template <class Design>
const Bench<Design>* netlist() {
  for (const auto& variant : test::variants<Design>()) {
    if (variant.name.starts_with("gates/")) return variant.bench.get();
  }
  return nullptr;
}

TEST(LinearNetlist, MatchesOnHostileClocks) {
  const auto* bench = netlist<linear::Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  EXPECT_EQ(test::expect_match(hostile_sweep(*bench, 1, kHostileClocks)).clocks, kHostileClocks);
}

TEST(LinearNetlist, DrawsEveryLine) {
  const auto* bench = netlist<linear::Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  linear::printed::expect_table3(*bench);
  linear::counted::expect_every_line(*bench);
}

TEST(CircularNetlist, MatchesOnHostileClocks) {
  const auto* bench = netlist<circular::Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  EXPECT_EQ(test::expect_match(hostile_sweep(*bench, 1, kHostileClocks)).clocks, kHostileClocks);
}

TEST(CircularNetlist, DrawsEveryArc) {
  const auto* bench = netlist<circular::Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  circular::printed::expect_tables(*bench);
  circular::counted::expect_every_start(*bench, ones(bench->params().width));
  circular::counted::expect_every_stop(*bench, ones(bench->params().width));
}

TEST(DdaNetlist, MatchesOnHostileClocks) {
  const auto* bench = netlist<dda::Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  EXPECT_EQ(test::expect_match(hostile_sweep(*bench, 1, kHostileClocks)).clocks, kHostileClocks);
}

TEST(DdaNetlist, DrawsEveryQuarter) {
  const auto* bench = netlist<dda::Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  test::expect_match(dda::every_quarter(*bench));
  test::expect_match(dda::random_jobs(*bench, 1, 500));
}

}  // namespace
}  // namespace cosim

// Netlists in the testbench, in place of the RTL and behind its adapters: hostile clocks, and all
// the work there is at a small width.
#pragma once

#include "tests/rtl/variant.h"
#include "tests/support/sweeps.h"

namespace cosim::test {

/// The bench of the one netlist of a design; null where there is no yosys to make it.
template <class Design>
const Bench<Design>* netlist() {
  for (const auto& variant : variants<Design>()) {
    if (variant.name.starts_with("gates/")) return variant.bench.get();
  }
  return nullptr;
}

/// It matches on hostile clocks.
inline void expect_match_on_hostile_clocks(const AnyBench& netlist) {
  constexpr std::uint64_t clocks = 100'000;
  EXPECT_EQ(expect_match(hostile_sweep(netlist, 1, clocks)).clocks, clocks);
}

}  // namespace cosim::test

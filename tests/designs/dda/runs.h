// What a job draws, clock by clock, on a bench.
#pragma once

#include <vector>

#include "tb/designs/dda/sweeps.h"
#include "tests/designs/dda/records.h"
#include "tests/support/recorder.h"

namespace cosim::dda {

constexpr Settings kEverySettings[] = {{Update::parallel, Preload::zero, true},
                                       {Update::parallel, Preload::half, true},
                                       {Update::sequential, Preload::zero, true},
                                       {Update::sequential, Preload::half, true}};

/// The clocks on which the machine ran.
inline std::vector<test::Recorder<Design>::Clock> running(const DdaBench& bench, const Job& job) {
  auto clocks = test::draw(bench, {&job, 1});
  std::erase_if(clocks, [](const auto& c) { return !is_busy(c.outputs); });
  return clocks;
}

/// The point before each running clock.
inline std::vector<Point> points(const DdaBench& bench, const Job& job) {
  std::vector<Point> all;
  for (const auto& c : running(bench, job)) {
    const auto number = [&](Word code) {
      return from_twos_complement(code, width_of(bench.params()) + 1);
    };
    const auto held = named<Held>(c.registers);
    all.push_back({number(held.x), number(held.y)});
  }
  return all;
}

}  // namespace cosim::dda

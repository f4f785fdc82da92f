// Stimuli that are drawn for the benchmark alone.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "loops.h"
#include "tb/dut/named_adapter.h"

namespace cosim::bench {

/// A number below n.
struct Below {
  std::mt19937_64 bits{1};
  Word operator()(Word n) { return static_cast<Word>(bits() % static_cast<std::uint64_t>(n)); }
};

/// Adds the loops on what the host drives for jobs that `draw(below)` makes.
template <class Adapter, class Draw>
void measure_jobs(const std::string& name, Draw draw) {
  measure_loops<Adapter>(name, [draw] {
    Below below;
    std::vector<JobOf<typename Adapter::Design>> jobs;
    for (int i = 0; i < 1000; ++i) jobs.push_back(draw(below));
    return inputs_of<Adapter>(jobs);
  });
}

}  // namespace cosim::bench

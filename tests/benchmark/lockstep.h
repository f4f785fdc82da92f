// What full lockstep costs one case at a time (loops.h), and in lanes, as a sweep runs them:
// hostile clocks, all of whose cost is in, the drawing, the beginning of each case, the comparison;
// and whole jobs of random length, judged by the oracle. A design adds its own in
// tests/designs/NAME/benchmark.
#pragma once

#include "tb/lanes/player.h"
#include "tests/benchmark/loops.h"
#include "tests/support/in_lanes.h"

namespace cosim::bench {

// The least that compares, with nothing of what explains a failure: of a machine whose reset sets
// every register.
template <class Adapter>
void compared(benchmark::State& state, const InputList<Adapter>& list) {
  using Design = typename Adapter::Design;
  const Source<typename Design::template Inputs<Word>> source{&list};
  Adapter dut(1);
  for (auto _ : state) {
    auto model = reset_state_of<Design, Word>(Adapter::params);
    dut.drive(Design::reset_inputs());
    dut.eval(false);
    dut.eval(true);
    typename Design::template Outputs<Word> seen;
    const auto clock = [&](const auto& in) __attribute__((flatten)) {
      const auto step = Design::next(Adapter::params, model, in);
      const Compared<Design> expected = {Design::registers(Adapter::params, model), step.outputs};
      dut.drive(in);
      dut.eval(false);
      const Compared<Design> actual = {dut.registers(), dut.outputs()};
      dut.eval(true);
      model = step.state;
      seen = step.outputs;
      return (difference(expected.registers, actual.registers) |
              difference(expected.outputs, actual.outputs)) == 0;
    };
    auto left = source;
    typename Design::template Inputs<Word> in;
    while (left.next(in, seen)) {
      if (!clock(in)) state.SkipWithError("RTL and model differ");
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(list.size()));
}

inline void in_lanes(benchmark::State& state, const AnyBench& bench, int lanes) {
  const auto built = test::in_lanes(bench, lanes);
  const auto at_once = static_cast<std::uint64_t>(lanes);
  constexpr std::uint64_t clocks = 1000;
  lanes::Player player(*built, bench);
  std::uint64_t first = 0;
  for (auto _ : state) {
    player.begin(1, first, at_once);
    if (player.run(clocks)) state.SkipWithError("RTL and model differ");
    first += at_once;
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(at_once * clocks));
}

// Whole jobs, which some thousand cases a time begin with and end without one in most lanes.
inline void jobs_in_lanes(benchmark::State& state, const AnyBench& bench, const Sweep& sweep,
                          int lanes) {
  const auto built = test::jobs_in_lanes(bench, lanes);
  const Sweep some = lanes::job_sweep(bench, *built, sweep);
  std::uint64_t first = 0, clocks = 0;
  for (auto _ : state) {
    const Result result = some.run_some(first, some.at_once);
    if (!result.match()) state.SkipWithError("RTL and model differ");
    first += some.at_once;
    clocks += result.clocks;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(clocks));
}

// The built bench of the adapter's parameters.
template <class Adapter>
const Bench<typename Adapter::Design>& bench_of() {
  const auto words = [](const auto& list) {
    std::string all;
    for (const Parameter& p : list) all += to_text(p) + ' ';
    return all;
  };
  for (const auto* bench : benches_of<typename Adapter::Design>()) {
    if (words(bench->parameters()) == words(Adapter::Design::parameters(Adapter::params)))
      return *bench;
  }
  throw std::logic_error("no bench of the adapter's parameters");
}

/// Adds those of the adapter's machine: `job(params, 1, i)` is the i-th of its jobs, and
/// `sweep(bench, 1, count)` a sweep of so many that has lanes.
template <class Adapter, class MakeJob, class MakeSweep>
bool measure(const std::string& name, MakeJob job, MakeSweep sweep) {
  const auto list = [job] {
    std::vector<JobOf<typename Adapter::Design>> jobs;
    for (std::uint64_t i = 0; i < 1000; ++i) jobs.push_back(job(Adapter::params, 1, i));
    return inputs_of<Adapter>(jobs);
  };
  measure_loops<Adapter>(name, list);
  add_loop<Adapter>(name + "/compared", list, compared<Adapter>);
  for (const int lanes : {512, 256, 64}) {
    if (lanes > lanes::widest()) continue;
    benchmark::RegisterBenchmark(
        (name + "/lanes" + std::to_string(lanes)).c_str(),
        [=](benchmark::State& state) { in_lanes(state, bench_of<Adapter>(), lanes); });
    benchmark::RegisterBenchmark(
        (name + "/jobs" + std::to_string(lanes)).c_str(), [=](benchmark::State& state) {
          const auto& bench = bench_of<Adapter>();
          jobs_in_lanes(state, bench, sweep(bench, 1, std::uint64_t{1} << 40), lanes);
        });
  }
  return true;
}

}  // namespace cosim::bench

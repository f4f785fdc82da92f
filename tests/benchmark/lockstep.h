// What full lockstep costs: clocks a second of the bare Verilated evaluate loop, of the least that
// compares, with nothing of what explains a failure, and of lockstep as a sweep runs it, on the
// same machine at 16 bits with the same inputs, in one run. The stimulus is made beforehand, so
// that its cost is in none. And hostile clocks in lanes, as a sweep runs them, all of whose cost is
// in: the drawing, the beginning of each case, the comparison. And whole jobs of random length in
// lanes, judged by the oracle. A design adds its own in
// tests/designs/NAME/benchmark.
#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "tb/lanes/player.h"
#include "tb/lockstep/run.h"
#include "tests/support/in_lanes.h"

namespace cosim::bench {

template <class Adapter>
using InputList = std::vector<typename Adapter::Design::template Inputs<Word>>;

inline constexpr std::size_t rows = 1 << 14;

// The inputs of work after work from a reset on: what the host drives when the model answers it.
template <class Adapter, class Job>
auto inputs_of(const std::vector<Job>& jobs) {
  using Design = typename Adapter::Design;
  std::vector<typename Design::template Inputs<Word>> inputs{Design::reset_inputs()};
  auto state = reset_state_of<Design, Word>();
  typename Design::template Outputs<Word> seen;
  typename Design::template Inputs<Word> in;
  HostOf<Design> host(Adapter::params, jobs);
  while (inputs.size() < rows && host.next(in, seen)) {
    inputs.push_back(in);
    const auto step = Design::next(Adapter::params, state, in);
    seen = step.outputs;
    state = step.state;
  }
  return inputs;
}

template <class Adapter>
void bare(benchmark::State& state, const InputList<Adapter>& list) {
  Adapter dut(1);
  for (auto _ : state) {
    for (const auto& in : list) {
      dut.drive(in);
      dut.eval(false);
      dut.eval(true);
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(list.size()));
}

// The list as what a sweep's case has.
template <class Inputs>
struct Source {
  const std::vector<Inputs>* list;
  std::size_t at = 0;
  template <class Outputs>
  bool next(Inputs& in, const Outputs&) {
    if (at == list->size()) return false;
    in = (*list)[at++];
    return true;
  }
};

template <class Adapter>
void compared(benchmark::State& state, const InputList<Adapter>& list) {
  using Design = typename Adapter::Design;
  const Source<typename Design::template Inputs<Word>> source{&list};
  Adapter dut(1);
  for (auto _ : state) {
    auto model = reset_state_of<Design, Word>();
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

template <class Adapter>
void lockstep(benchmark::State& state, const InputList<Adapter>& list) {
  const Source<typename Adapter::Design::template Inputs<Word>> source{&list};
  for (auto _ : state) {
    Lockstep<Adapter> both(1U);
    auto left = source;
    std::uint64_t clocks = 0;
    const auto nothing = [](const auto&, const auto&) {};
    if (!clock_fast(both, left, clocks, nothing)) state.SkipWithError("they differ");
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
    if (words(bench->parameters()) ==
        words(parameters_of<typename Adapter::Design>(Adapter::params)))
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
  const auto add = [&](const char* kind,
                       void (*run)(benchmark::State&, const InputList<Adapter>&)) {
    benchmark::RegisterBenchmark((name + kind).c_str(),
                                 [=](benchmark::State& state) { run(state, list()); });
  };
  add("/bare", bare<Adapter>);
  add("/compared", compared<Adapter>);
  add("/lockstep", lockstep<Adapter>);
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

// What lockstep costs: clocks a second of the bare Verilated evaluate loop, and of lockstep as a
// sweep runs it, on the same machine with the same inputs, in one run. The stimulus is made
// beforehand, so that its cost is in none.
#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "tb/sim/run.h"

namespace cosim::bench {

template <class Adapter>
using InputList = std::vector<typename Adapter::Design::template Inputs<Word>>;

inline constexpr std::size_t rows = 1 << 14;

// The inputs of work after work from a reset on: what the host drives when the model answers it.
template <class Adapter, class Job>
auto inputs_of(const std::vector<Job>& jobs) {
  using Design = typename Adapter::Design;
  std::vector<typename Design::template Inputs<Word>> inputs{Design::reset_inputs()};
  auto state = reset_state_of<Design, Word>(Adapter::params);
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

/// Adds `run` of the adapter's machine, on what `list()` makes.
template <class Adapter, class MakeList>
void add_loop(const std::string& name, MakeList list,
              void (*run)(benchmark::State&, const InputList<Adapter>&)) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { run(state, list()); });
}

/// Adds the bare loop and lockstep.
template <class Adapter, class MakeList>
void measure_loops(const std::string& name, MakeList list) {
  add_loop<Adapter>(name + "/bare", list, bare<Adapter>);
  add_loop<Adapter>(name + "/lockstep", list, lockstep<Adapter>);
}

}  // namespace cosim::bench

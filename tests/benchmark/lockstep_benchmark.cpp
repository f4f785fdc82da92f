// What full lockstep costs: clocks a second of the bare Verilated evaluate loop, of the least that
// compares, with nothing of what explains a failure, and of lockstep as a sweep runs it, on the
// same machine at 16 bits with the same inputs, in one run. The stimulus is made beforehand, so
// that its cost is in none.
#include <benchmark/benchmark.h>

#include <vector>

#include "VcircularW16.h"
#include "VcircularW16___024root.h"
#include "VddaW16.h"
#include "VddaW16___024root.h"
#include "VlinearM16N13.h"
#include "VlinearM16N13___024root.h"
#include "adapters/circular.h"
#include "adapters/dda.h"
#include "adapters/linear.h"
#include "tb/designs/circular/sweeps.h"
#include "tb/designs/dda/sweeps.h"
#include "tb/designs/linear/sweeps.h"
#include "tb/lockstep/run.h"

namespace {

using namespace cosim;

using Linear = linear::Adapter<VlinearM16N13, linear::Params{16, 13}>;
using Circular = circular::Adapter<VcircularW16, circular::Params{16}>;
using Dda = dda::Adapter<VddaW16, dda::Params{16}>;

constexpr std::size_t rows = 1 << 14;

// The inputs of work after work from a clear on: what the host drives when the model answers it.
template <class Adapter, class Job>
auto inputs_of(const std::vector<Job>& jobs) {
  using Design = typename Adapter::Design;
  std::vector<typename Design::template Inputs<Word>> inputs{Design::clear()};
  auto state = Design::template cleared<Word>();
  typename Design::template Outputs<Word> seen;
  typename Design::template Inputs<Word> in;
  typename Design::Host host(Adapter::params, jobs);
  while (inputs.size() < rows && host.next(in, seen)) {
    inputs.push_back(in);
    const auto step = Design::next(Adapter::params, state, in);
    seen = step.outputs;
    state = step.state;
  }
  return inputs;
}

template <class Adapter>
auto inputs();

template <>
auto inputs<Linear>() {
  std::vector<linear::Job> jobs;
  for (std::uint64_t i = 0; i < 1000; ++i)
    jobs.push_back(linear::random_line(Linear::params, 1, i));
  return inputs_of<Linear>(jobs);
}

template <>
auto inputs<Circular>() {
  std::vector<circular::Arc> arcs;
  for (std::uint64_t i = 0; i < 1000; ++i)
    arcs.push_back(circular::random_arc(Circular::params, 1, i));
  return inputs_of<Circular>(arcs);
}

template <>
auto inputs<Dda>() {
  std::vector<dda::Job> jobs;
  for (std::uint64_t i = 0; i < 1000; ++i) jobs.push_back(dda::random_job(Dda::params, 1, i));
  return inputs_of<Dda>(jobs);
}

template <class Adapter>
void bare(benchmark::State& state) {
  const auto list = inputs<Adapter>();
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
void compared(benchmark::State& state) {
  using Design = typename Adapter::Design;
  const auto list = inputs<Adapter>();
  const Source<typename Design::template Inputs<Word>> source{&list};
  Adapter dut(1);
  for (auto _ : state) {
    auto model = Design::template cleared<Word>();
    dut.drive(Design::clear());
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
void lockstep(benchmark::State& state) {
  const auto list = inputs<Adapter>();
  const Source<typename Adapter::Design::template Inputs<Word>> source{&list};
  for (auto _ : state) {
    Lockstep<Adapter> both(1U);
    auto left = source;
    std::uint64_t clocks = 0;
    const auto nothing = [](const auto&, const auto&) {};
    if (!clock_through(both, left, clocks, nothing)) state.SkipWithError("they differ");
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(list.size()));
}

BENCHMARK_TEMPLATE(bare, Linear)->Name("linear_M16N13/bare");
BENCHMARK_TEMPLATE(compared, Linear)->Name("linear_M16N13/compared");
BENCHMARK_TEMPLATE(lockstep, Linear)->Name("linear_M16N13/lockstep");
BENCHMARK_TEMPLATE(bare, Circular)->Name("circular_W16/bare");
BENCHMARK_TEMPLATE(compared, Circular)->Name("circular_W16/compared");
BENCHMARK_TEMPLATE(lockstep, Circular)->Name("circular_W16/lockstep");
BENCHMARK_TEMPLATE(bare, Dda)->Name("dda_W16/bare");
BENCHMARK_TEMPLATE(compared, Dda)->Name("dda_W16/compared");
BENCHMARK_TEMPLATE(lockstep, Dda)->Name("dda_W16/lockstep");

}  // namespace

BENCHMARK_MAIN();

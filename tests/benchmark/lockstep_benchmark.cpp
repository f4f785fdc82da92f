// What full lockstep costs: clocks a second of the bare Verilated evaluate loop and of lockstep, on
// the same machine at 16 bits with the same inputs, in one run. The stimulus is made beforehand, so
// that its cost is in neither.
#include <benchmark/benchmark.h>

#include <vector>

#include "VcircularW16.h"
#include "VcircularW16___024root.h"
#include "VddaW16.h"
#include "VddaW16___024root.h"
#include "VlinearM16N13.h"
#include "VlinearM16N13___024root.h"
#include "tb/adapter/circular.h"
#include "tb/adapter/dda.h"
#include "tb/adapter/linear.h"
#include "tb/circular_sweeps.h"
#include "tb/dda_sweeps.h"
#include "tb/linear_sweeps.h"
#include "tb/lockstep.h"

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

template <class Adapter>
void lockstep(benchmark::State& state) {
  const auto list = inputs<Adapter>();
  Lockstep<Adapter> both(1);
  for (auto _ : state) {
    for (const auto& in : list) {
      if (!both.clock(in)) state.SkipWithError("RTL and model differ");
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(list.size()));
}

BENCHMARK_TEMPLATE(bare, Linear)->Name("linear_M16N13/bare");
BENCHMARK_TEMPLATE(lockstep, Linear)->Name("linear_M16N13/lockstep");
BENCHMARK_TEMPLATE(bare, Circular)->Name("circular_W16/bare");
BENCHMARK_TEMPLATE(lockstep, Circular)->Name("circular_W16/lockstep");
BENCHMARK_TEMPLATE(bare, Dda)->Name("dda_W16/bare");
BENCHMARK_TEMPLATE(lockstep, Dda)->Name("dda_W16/lockstep");

}  // namespace

BENCHMARK_MAIN();

// Transactions a second through the same filter, on the same cases with the same stalls, drawn
// beforehand: the bare loop, which compares nothing; a scoreboard by hand; the harness; and the
// harness as a sweep runs it, which draws its cases too.
#include <benchmark/benchmark.h>

#include <numeric>

#include "VfirW12STAGES3_ports.h"
#include "by_hand.h"
#include "fir/fir.h"
#include "tb/stream/draw.h"
#include "tb/stream/stream_bench.h"

namespace {

using namespace cosim;

struct Trait {
  using Model = Fir<12, 3>;
  struct Says {
    static constexpr const char* name = "fir";
    static constexpr std::array<std::array<Parameter, 2>, 1> parameters{
        {{Parameter{"W", 12}, Parameter{"STAGES", 3}}}};
  };
  using Design = clocked::StreamDesign<Says, Model>;
  static constexpr Design::Params params{};
  static constexpr const char *clock = "clk", *clocks = "";
};
using Bench = StreamBench<Trait, VerilatedStreamDut<VfirW12STAGES3>>;

const Bench& bench() {
  static const Bench one;
  return one;
}

constexpr std::uint64_t seed = 1, cases = 200, most = 1000;

Stimulus drawn(std::uint64_t i) {
  const auto any = [](std::size_t, std::span<const Word>) { return true; };
  return draw_stream_case(bench().shape(), seed, i, most, any);
}
const std::vector<Stimulus>& stimuli() {
  static const auto all = [] {
    std::vector<Stimulus> list;
    for (std::uint64_t i = 0; i < cases; ++i) list.push_back(drawn(i));
    return list;
  }();
  return all;
}
// The columns are x_give, x_stall, x_data, y_stall and y_waits, and every row gives.
const std::vector<by_hand::Case>& cases_by_hand() {
  static const auto all = [] {
    std::vector<by_hand::Case> list;
    for (const Stimulus& s : stimuli()) {
      by_hand::Case one;
      for (const auto& row : s.clocks) {
        one.stalls.push_back(static_cast<int>(row[1]));
        one.samples.push_back(static_cast<int>(from_twos_complement(row[2], 12)));
        one.waits.push_back(static_cast<int>(row[3]));
        one.sees_valid.push_back(row[4] != 0);
      }
      list.push_back(std::move(one));
    }
    return list;
  }();
  return all;
}
std::int64_t transactions() {
  return std::accumulate(stimuli().begin(), stimuli().end(), std::int64_t{0},
                         [](std::int64_t sum, const Stimulus& s) {
                           return sum + static_cast<std::int64_t>(s.clocks.size());
                         });
}

template <class Each>
void measure(benchmark::State& state, const Each& each) {
  for (auto _ : state) {
    for (std::size_t i = 0; i < cases; ++i) {
      if (!each(i)) state.SkipWithError("RTL and model differ");
    }
  }
  state.SetItemsProcessed(state.iterations() * transactions());
}

void bare(benchmark::State& state) {
  VerilatedContext context;
  VfirW12STAGES3 top(&context);
  measure(state, [&](std::size_t i) {
    const by_hand::Case& given = cases_by_hand()[i];
    const auto clock = [&] {
      top.clk = 0;
      top.eval();
      const bool taken = top.x_valid != 0 && top.x_ready != 0;
      const bool offered = top.y_valid != 0;
      top.clk = 1;
      top.eval();
      return std::pair{taken, offered};
    };
    top.rst = 1;
    top.x_valid = top.y_ready = 0;
    clock();
    clock();
    top.rst = 0;
    const std::size_t all = given.samples.size();
    int stall = given.stalls[0], wait = given.waits[0];
    bool unseen = given.sees_valid[0];
    for (std::size_t n = 0, m = 0; m < all;) {
      top.x_valid = n < all && stall == 0 ? 1 : 0;
      if (n < all) top.x_data = static_cast<std::uint16_t>(given.samples[n] & 0xfff);
      top.y_ready = wait == 0 && !unseen ? 1 : 0;
      if (stall > 0) --stall;
      if (wait > 0) --wait;
      const auto [taken, offered] = clock();
      if (taken && ++n < all) stall = given.stalls[n];
      unseen &= !offered;
      if (offered && top.y_ready != 0 && ++m < all) {
        wait = given.waits[m];
        unseen = given.sees_valid[m];
      }
    }
    return true;
  });
}
void scoreboard(benchmark::State& state) {
  VerilatedContext context;
  VfirW12STAGES3 top(&context);
  measure(state, [&](std::size_t i) {
    const by_hand::Case& given = cases_by_hand()[i];
    return by_hand::run(top, given) == given.samples.size();
  });
}
void harness(benchmark::State& state) {
  measure(state, [](std::size_t i) { return !bench().first_difference(stimuli()[i]); });
}
// The cases share the clocks of a hostile one that has just enough for them.
void sweep(benchmark::State& state) {
  HostileCase all{seed, 0, most};
  all.clocks = std::accumulate(
      stimuli().begin(), stimuli().end(), std::uint64_t{0},
      [](std::uint64_t sum, const Stimulus& s) { return sum + bench().replay(s, {}).clocks; });
  for (auto _ : state) {
    if (bench().run_hostile(all).mismatch) state.SkipWithError("RTL and model differ");
  }
  state.SetItemsProcessed(state.iterations() * transactions());
}

BENCHMARK(bare);
BENCHMARK(scoreboard)->Name("by_hand");
BENCHMARK(harness);
BENCHMARK(sweep);

}  // namespace

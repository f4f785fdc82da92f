// What mutants are attacked with: the printed examples, hostile clocks, whole jobs at random, long
// ones. A design says in tb/designs/NAME/mutation/jobs.h what its jobs are; hostile clocks need
// nothing.
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tb/mutation/mutants.h"
#include "tb/sweep/sweep.h"

namespace cosim::mutation {

/// The jobs of a design. Each function gives the jobs of one run.
template <class Design>
struct Jobs {
  using List = std::vector<typename HostOf<Design>::Job>;
  static List printed(const typename Design::Params&) { return {}; }
  static List random(const typename Design::Params&, std::uint64_t /*seed*/, std::uint64_t /*i*/) {
    return {};
  }
  static List longest(const typename Design::Params&, std::uint64_t /*seed*/, std::uint64_t /*i*/) {
    return {};
  }
};

inline constexpr std::uint64_t campaign_seed = 1;
inline constexpr std::uint64_t long_jobs = 16;

/// Draws jobs on a new machine; the same jobs get the same power-up state.
template <class Design>
Case drawing(const Bench<Design>& bench, std::string name, typename Jobs<Design>::List jobs,
             std::uint64_t number) {
  const auto power_up = static_cast<std::uint32_t>(number);
  const auto run = [&bench, jobs, power_up] {
    Observers<Design> nobody{};
    return bench.open(power_up)->draw(jobs, nobody);
  };
  const auto before = [&bench, jobs, power_up](const Watch& watch) {
    bench.watch_drawn(jobs, power_up, watch);
  };
  return {std::move(name), run, before, power_up};
}

inline Case hostile(const AnyBench& bench, std::uint64_t i) {
  const HostileCase c{campaign_seed, i, 1000};
  return {fmt::format("hostile clocks, case {}", i), [&bench, c] { return bench.run_hostile(c); },
          [&bench, c](const Watch& watch) { bench.watch_hostile(c, watch); }, c.power_up()};
}

/// Jobs of a design that declares them.
inline Case declared(const AnyBench& bench, std::uint64_t i) {
  const auto power_up = static_cast<std::uint32_t>(i);
  return {fmt::format("random jobs {}", i),
          [&bench, i, power_up] {
            return bench.run_jobs(random_jobs(bench, campaign_seed, i), power_up).run;
          },
          [&bench, i, power_up](const Watch& watch) {
            bench.watch_jobs(random_jobs(bench, campaign_seed, i), power_up, watch);
          },
          power_up};
}

/// Cases first .. last - 1 of hostile clocks and of random jobs, by turns.
template <class Design>
void add_cases(std::vector<Case>& all, const Bench<Design>& bench, std::uint64_t first,
               std::uint64_t last) {
  for (std::uint64_t i = first; i < last; ++i) {
    all.push_back(hostile(bench, i));
    auto jobs = Jobs<Design>::random(bench.params(), campaign_seed, i);
    if (!jobs.empty()) {
      all.push_back(drawing(bench, fmt::format("random job {}", i), std::move(jobs), i));
    }
    if (!bench.job_fields().empty()) all.push_back(declared(bench, i));
  }
}

constexpr std::uint64_t quick_cases = 12;
constexpr std::uint64_t thorough_cases = 3000;

/// All of them, on `bench`, which must outlive them.
template <class Design>
Cases cases_of(const Bench<Design>& bench) {
  Cases cases;
  auto printed = Jobs<Design>::printed(bench.params());
  if (!printed.empty()) {
    cases.all.push_back(drawing(bench, "printed example", std::move(printed), 0));
  }
  add_cases(cases.all, bench, 0, quick_cases);
  cases.quick = cases.all.size();
  for (std::uint64_t i = 0; i < long_jobs; ++i) {
    auto jobs = Jobs<Design>::longest(bench.params(), campaign_seed, i);
    if (jobs.empty()) break;
    cases.all.push_back(drawing(bench, fmt::format("long job {}", i), std::move(jobs), i));
  }
  add_cases(cases.all, bench, quick_cases, thorough_cases);
  return cases;
}

}  // namespace cosim::mutation

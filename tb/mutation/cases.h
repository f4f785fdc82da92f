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

inline constexpr std::uint64_t seed = 1;
inline constexpr std::uint64_t long_jobs = 4;

/// Draws jobs on a new machine; the same jobs get the same power-up state.
template <class Design>
Case drawing(const Bench<Design>& bench, std::string name, typename Jobs<Design>::List jobs,
             std::uint64_t power_up) {
  const auto run = [&bench, jobs = std::move(jobs), power_up] {
    Observers<Design> nobody{};
    return bench.open(static_cast<std::uint32_t>(power_up))->draw(jobs, nobody);
  };
  return {std::move(name), run};
}

template <class Design>
Case hostile(const Bench<Design>& bench, std::uint64_t i) {
  return {fmt::format("hostile clocks, case {}", i), [&bench, i] {
            return bench.run_hostile({seed, i, 1000});
          }};
}

/// Cases first .. last - 1 of hostile clocks and of random jobs, by turns.
template <class Design>
void add_cases(std::vector<Case>& all, const Bench<Design>& bench, std::uint64_t first,
               std::uint64_t last) {
  for (std::uint64_t i = first; i < last; ++i) {
    all.push_back(hostile(bench, i));
    auto jobs = Jobs<Design>::random(bench.params(), seed, i);
    if (!jobs.empty()) {
      all.push_back(drawing(bench, fmt::format("random job {}", i), std::move(jobs), i));
    }
    if constexpr (DeclaresJobs<Design>) {
      all.push_back(
          {fmt::format("random jobs {}", i), [&bench, i] {
             return bench.run_jobs(random_jobs(bench, seed, i), static_cast<std::uint32_t>(i)).run;
           }});
    }
  }
}

constexpr std::uint64_t quick_cases = 12;
constexpr std::uint64_t thorough_cases = 2000;

template <class Design>
std::vector<Case> quick_cases_of(const Bench<Design>& bench) {
  std::vector<Case> all;
  auto printed = Jobs<Design>::printed(bench.params());
  if (!printed.empty()) all.push_back(drawing(bench, "printed example", std::move(printed), 0));
  add_cases(all, bench, 0, quick_cases);
  return all;
}

/// Adds the others. The number of stimuli before.
template <class Design>
std::size_t add_thorough_cases(std::vector<Case>& all, const Bench<Design>& bench) {
  const std::size_t before = all.size();
  for (std::uint64_t i = 0; i < long_jobs; ++i) {
    auto jobs = Jobs<Design>::longest(bench.params(), seed, i);
    if (jobs.empty()) break;
    all.push_back(drawing(bench, fmt::format("long job {}", i), std::move(jobs), i));
  }
  add_cases(all, bench, quick_cases, thorough_cases);
  return before;
}

}  // namespace cosim::mutation

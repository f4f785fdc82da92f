// Sweeps whose cases are jobs of a type of the design's own.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "tb/sim/lane_jobs.h"
#include "tb/sim/sweep.h"

namespace cosim {

/// Draws the jobs one after the other on one machine; Figures as JobCheck has them.
template <class Figures, class Design>
Result drawn(const Bench<Design>& bench, std::span<const JobOf<Design>> jobs,
             std::uint32_t power_up) {
  JobCheck<Design, Figures> check(bench.params(), jobs);
  Run run = bench.open(power_up)->draw(jobs, check);
  return result_of(std::move(run), check.so_far());
}

/// Case i draws the jobs of i on a machine powered up from i, one case at a time or in lanes;
/// describe(i) says what they are.
template <class Figures, class Design, class Describe>
Sweep drawn_sweep(const Bench<Design>& bench, std::string name, std::uint64_t cases,
                  JobsOf<JobOf<Design>> jobs, std::uint64_t cases_a_lane, Describe describe) {
  const auto run = [&bench, jobs, describe](std::uint64_t i) {
    Result result =
        drawn<Figures>(bench, all_of<JobOf<Design>>(jobs(i)), static_cast<std::uint32_t>(i));
    if (!result.match()) result.failed = describe(i);
    return result;
  };
  Sweep sweep{std::move(name), cases, run};
  sweep.in_lanes =
      std::make_shared<LaneJobsOf<Design, Figures>>(bench.params(), std::move(jobs), cases_a_lane);
  return sweep;
}

/// The same of one job a case.
template <class Figures, class Design, class OneJob, class Describe>
Sweep drawn_sweep_of_one(const Bench<Design>& bench, const char* name, std::uint64_t cases,
                         OneJob one, Describe describe) {
  constexpr std::uint64_t cases_a_lane = 128;
  return drawn_sweep<Figures>(
      bench, name, cases,
      [one](std::uint64_t i) {
        return [one, i, is_over = false](JobOf<Design>& job) mutable {
          if (is_over) return false;
          job = one(i);
          return is_over = true;
        };
      },
      cases_a_lane, [one, describe](std::uint64_t i) { return describe(one(i)); });
}

}  // namespace cosim

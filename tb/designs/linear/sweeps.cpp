#include "tb/designs/linear/sweeps.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "model/linear/control_code.h"
#include "model/linear/oracle.h"
#include "tb/bench/lane_jobs.h"
#include "tb/designs/linear/check.h"
#include "tb/designs/linear/lanes.h"

namespace cosim::linear {

namespace {

using Lines = std::function<bool(Job&)>;

}  // namespace

Result run_lines(const LinearBench& bench, std::span<const Job> jobs, std::uint32_t power_up) {
  Check check(bench.params(), jobs);
  return result_of(bench.open(power_up)->draw(jobs, check), check);
}

Sweep every_line(const LinearBench& bench) {
  const int m = bench.params().m;
  const auto lines_of = [m](std::uint64_t major) -> Lines {
    return [major = static_cast<std::int64_t>(major), codes = Code{1} << m,
            code = Code{0}](Job& job) mutable {
      job = {{major, code}, {}};
      return code++ < codes;
    };
  };
  const auto run = [&bench, lines_of](std::uint64_t major) {
    const std::vector<Job> jobs = all_of<Job>(lines_of(major));
    Result result = run_lines(bench, jobs, static_cast<std::uint32_t>(major));
    result.failed = fmt::format("BP = {} with every UK", major);
    return result;
  };
  Sweep sweep{"every BP with every UK", std::uint64_t{1} << m, run};
  sweep.in_lanes = std::make_shared<LaneLines>(bench.params(), lines_of, 1);
  return sweep;
}

Job random_line(const Params& p, std::uint64_t seed, std::uint64_t i) {
  constexpr std::int64_t longest = 2000;
  Random random = Random::for_case(seed, i);
  Job job;
  job.line.major = random.corner(p.m);
  job.line.code = random.one_in_power(2)
                      ? best_code(p.m, job.line.major,
                                  static_cast<std::int64_t>(
                                      random.below(static_cast<std::uint64_t>(job.line.major) + 1)))
                      : static_cast<Code>(random.corner(p.m));
  if (ticks(p.gamma(), job.line.major) > longest) {
    job.words = static_cast<std::int64_t>(random.below(longest));
  }
  return job;
}

Sweep random_lines(const LinearBench& bench, std::uint64_t seed, std::uint64_t count) {
  const auto run = [&bench, seed](std::uint64_t i) {
    const Job job = random_line(bench.params(), seed, i);
    Result result = run_lines(bench, {&job, 1}, static_cast<std::uint32_t>(i));
    result.failed = fmt::format("BP = {}, UK = {:0{}b}, seed {}", job.line.major, job.line.code,
                                bench.params().m, seed);
    return result;
  };
  Sweep sweep{"random lines", count, run};
  const auto line_of = [p = bench.params(), seed](std::uint64_t i) {
    return one_by_one<Job>({random_line(p, seed, i)});
  };
  sweep.in_lanes = std::make_shared<LaneLines>(bench.params(), line_of, 128);
  return sweep;
}

}  // namespace cosim::linear

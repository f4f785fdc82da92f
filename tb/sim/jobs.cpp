// Declared jobs at random.
#include <algorithm>
#include <utility>

#include "tb/sim/sweep.h"
#include "tb/util/random.h"

namespace cosim {
namespace {

// Of the whole range, or often an end of it or the simplest value, or a little beside them.
Word random_value(const JobField& field, Random& random) {
  const std::uint64_t r = random.next();
  const Word off = static_cast<Word>((r >> 8) % 3);
  const auto size = static_cast<std::uint64_t>(field.high - field.low) + 1;
  switch (r & 7) {
    case 0:
      return std::min(field.low + off, field.high);
    case 1:
      return std::max(field.high - off, field.low);
    case 2:
      return std::min(simplest(field) + off, field.high);
    default:
      return field.low + static_cast<Word>(size == 0 ? random.next() : random.below(size));
  }
}

}  // namespace

JobList random_jobs(const AnyBench& bench, std::uint64_t seed, std::uint64_t i) {
  Random random = Random::for_case(seed, i);
  const auto fields = bench.job_fields();
  JobList jobs(1 + random.below(3));
  for (auto& job : jobs) {
    for (const JobField& field : fields) job.push_back(random_value(field, random));
  }
  return jobs;
}

Sweep job_sweep(const AnyBench& bench, std::uint64_t seed, std::uint64_t cases) {
  const auto jobs_of = [&bench, seed](std::uint64_t i) { return random_jobs(bench, seed, i); };
  const auto run = [&bench, jobs_of](std::uint64_t i) {
    const JobList jobs = jobs_of(i);
    JobsRun ran = bench.run_jobs(jobs, static_cast<std::uint32_t>(i));
    Result result = result_of(std::move(ran.run), std::move(ran.checked));
    if (!result.match()) result.failed = bench.describe(jobs);
    return result;
  };
  Sweep sweep{"random jobs", cases, run};
  sweep.in_lanes = bench.lane_jobs(jobs_of);
  return sweep;
}

}  // namespace cosim

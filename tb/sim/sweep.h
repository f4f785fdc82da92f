// Many cases on several threads. A case follows from its number alone, so any case can be run again
// by itself, and finished cases need no memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "tb/sim/bench.h"
#include "tb/sim/result.h"

namespace cosim {

class LaneJobs;  // lane_jobs.h

struct Sweep {
  std::string name;  ///< what is swept, for a person: "every BP and UK"
  std::uint64_t cases = 0;
  /// Runs case number i < cases. Called from several threads at once.
  std::function<Result(std::uint64_t i)> run;
  /// If not empty, runs cases number first .. first + count - 1, 1 <= count <= at_once, in place of
  /// `run`: the sum up to and with the first that fails. It too is called from several threads.
  std::function<Result(std::uint64_t first, std::uint64_t count)> run_some = {};
  std::uint64_t at_once = 1;
  /// What its cases are in lanes; none where they are not jobs or run one at a time only.
  std::shared_ptr<const LaneJobs> in_lanes = {};
};

/// Called now and then from the calling thread with the cases done so far.
using Progress = std::function<void(std::uint64_t done, std::uint64_t cases)>;

/// A sweep that continues an earlier one.
struct Resume {
  Result done;  ///< the first cases, as many as `done.cases`, all matching, added up
  /// Called now and then from the calling thread with what to continue from.
  std::function<void(const Result& done)> keep;
};

/// How many results, each of cases at once, a sweep remembers at most while an earlier case is
/// still running.
inline constexpr std::size_t most_waiting = 1 << 14;

/// Runs the cases on `threads` threads, >= 1. Of several failing cases the one with the smallest
/// number is reported, and the result is the sum up to and with it, whatever the threads did; no
/// case with a larger number is begun after it.
Result run_sweep(const Sweep& sweep, unsigned threads, const Progress& progress = {},
                 const Resume& resume = {});

/// Jobs at random for a bench whose design declares them, 1 to 3 a case on one machine.
Sweep job_sweep(const AnyBench& bench, std::uint64_t seed, std::uint64_t cases);
/// The jobs of case i.
JobList random_jobs(const AnyBench& bench, std::uint64_t seed, std::uint64_t i);

/// Hostile clocks for any bench, in cases of 1000.
Sweep hostile_sweep(const AnyBench& bench, std::uint64_t seed, std::uint64_t clocks);
/// What came of one of its cases.
Result hostile_result(const AnyBench& bench, const HostileCase& c, Run run);

}  // namespace cosim

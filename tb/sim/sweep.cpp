// Cases finish in any order and are added up in theirs, so that the sum does not depend on the
// threads: one that is early waits for those before it, and where too many wait, its thread does. A
// failure is an end for all cases behind it; those before it are finished, and the first failure is
// the one that is told.
#include "tb/sim/sweep.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <map>
#include <mutex>
#include <utility>

#include "tb/util/parallel.h"

namespace cosim {

Result run_sweep(const Sweep& sweep, unsigned threads, const Progress& progress,
                 const Resume& resume) {
  const std::uint64_t before = resume.done.cases;
  std::atomic<std::uint64_t> end{sweep.cases};
  std::mutex guard;  // of all below
  std::condition_variable room;
  Result sum = resume.done;                 // of the first cases
  std::map<std::uint64_t, Result> waiting;  // for a case before them; by their first
  const auto run = [&](std::uint64_t first) {
    if (sweep.run_some) return sweep.run_some(first, std::min(sweep.at_once, sweep.cases - first));
    Result one = sweep.run(first);
    one.cases = 1;
    return one;
  };

  const auto work = [&](std::uint64_t i) {
    try {
      Result one = run(i);
      std::unique_lock lock(guard);
      if (!one.match() && i < end) end = i;
      waiting.emplace(i, std::move(one));
      while (!waiting.empty() && waiting.begin()->first == sum.cases && sum.cases < end) {
        add(sum, std::move(waiting.begin()->second));
        waiting.erase(waiting.begin());
      }
      room.notify_all();
      room.wait(lock, [&] { return waiting.size() < most_waiting || sum.cases >= end; });
    } catch (...) {
      const std::lock_guard lock(guard);
      end = 0;
      room.notify_all();
      throw;
    }
    return i < end;
  };

  // The calling thread is kept for what reports and saves.
  auto all = std::async(std::launch::async, [&] {
    in_parallel((sweep.cases - before + sweep.at_once - 1) / sweep.at_once, threads,
                [&](std::uint64_t i) { return work(before + i * sweep.at_once); });
  });
  while (all.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
    std::unique_lock lock(guard);
    const std::uint64_t done = std::min(sum.cases + waiting.size() * sweep.at_once, sweep.cases);
    const Result first = sum;
    lock.unlock();
    if (progress) progress(done, sweep.cases);
    if (resume.keep) resume.keep(first);
  }
  all.get();
  if (sum.cases == end && end < sweep.cases) {
    Result& one = waiting.at(end);
    one.failed = fmt::format("case {}: {}", end + one.cases - 1, one.failed);
    add(sum, std::move(one));
  }
  if (progress) progress(sum.cases, sweep.cases);
  return sum;
}

Sweep hostile_sweep(const AnyBench& bench, std::uint64_t seed, std::uint64_t clocks) {
  static constexpr std::uint64_t length = 1000;
  const auto run = [&bench, seed, clocks](std::uint64_t i) {
    const HostileCase c{seed, i, std::min(length, clocks - i * length)};
    return hostile_result(bench, c, bench.run_hostile(c));
  };
  return {bench.hostile_text(), (clocks + length - 1) / length, run};
}

Result hostile_result(const AnyBench& bench, const HostileCase& c, Run run) {
  Result result;
  result.clocks = run.clocks;
  result.left_out = std::move(run.left_out);
  result.streams = std::move(run.streams);
  result.happened = std::move(run.happened);
  result.mismatch = std::move(run.mismatch);
  result.failed = bench.text_of(c);
  return result;
}

}  // namespace cosim

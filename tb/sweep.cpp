#include "tb/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace cosim {
namespace {

void add(Result& sum, const Result& one) {
  sum.cases += 1;
  sum.clocks += one.clocks;
  sum.checked.jobs += one.checked.jobs;
  sum.checked.steps += one.checked.steps;
  sum.checked.max_deviation = std::max(sum.checked.max_deviation, one.checked.max_deviation);
}

}  // namespace

Result run_sweep(const Sweep& sweep, unsigned threads, const Progress& progress) {
  std::atomic<std::uint64_t> next{0};
  std::atomic<std::uint64_t> end{sweep.cases};
  std::mutex guard;  // of all below
  std::condition_variable finished;
  Result sum;
  std::exception_ptr thrown;
  unsigned running = std::max(threads, 1U);

  const auto work = [&] {
    try {
      for (std::uint64_t i = next++; i < end; i = next++) {
        Result one = sweep.run(i);
        const std::lock_guard lock(guard);
        add(sum, one);
        if (!one.match() && i < end) {
          end = i;
          sum.mismatch = std::move(one.mismatch);
          sum.checked.error = std::move(one.checked.error);
          sum.failed = fmt::format("case {}: {}", i, one.failed);
        }
      }
    } catch (...) {
      const std::lock_guard lock(guard);
      thrown = std::current_exception();
      end = 0;
    }
    const std::lock_guard lock(guard);
    --running;
    finished.notify_one();
  };

  std::vector<std::jthread> pool;
  for (unsigned t = running; t > 0; --t) pool.emplace_back(work);
  {
    std::unique_lock lock(guard);
    while (!finished.wait_for(lock, std::chrono::milliseconds(100), [&] { return running == 0; })) {
      if (!progress) continue;
      const std::uint64_t done = sum.cases;
      lock.unlock();
      progress(done, sweep.cases);
      lock.lock();
    }
  }
  pool.clear();
  if (thrown) std::rethrow_exception(thrown);
  if (progress) progress(sum.cases, sweep.cases);
  return sum;
}

Sweep hostile_sweep(const AnyBench& bench, std::uint64_t seed, std::uint64_t clocks) {
  static constexpr std::uint64_t length = 1000;
  const auto run = [&bench, seed, clocks](std::uint64_t i) {
    const HostileCase c{seed, i, std::min(length, clocks - i * length)};
    Run r = bench.run_hostile(c);
    Result result;
    result.clocks = r.clocks;
    result.mismatch = std::move(r.mismatch);
    result.failed = fmt::format("{} hostile clocks, seed {}", c.clocks, seed);
    return result;
  };
  return {"any value on any pin on any clock", (clocks + length - 1) / length, run};
}

}  // namespace cosim

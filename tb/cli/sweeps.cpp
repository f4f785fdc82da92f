#include "tb/cli/sweeps.h"

#include <fmt/core.h>

#include <deque>
#include <set>

#include "model/core/input_error.h"
#include "tb/util/interrupt.h"

namespace cosim::cli {

const std::vector<const DesignSweeps*>& all_sweeps(const Registry& registry) {
  static std::deque<DesignSweeps> others;
  static const std::vector<const DesignSweeps*> all = [&registry] {
    std::vector<const DesignSweeps*> found;
    std::set<std::string> known;
    for (const DesignSweeps& design : registry.sweeps()) {
      known.insert(design.design);
      found.push_back(&design);
    }
    for (const auto& bench : benches()) {
      if (!known.insert(bench->design()).second) continue;
      const bool jobs = !bench->job_fields().empty();
      others.push_back({bench->design(),
                        jobs ? "Hostile clocks or random jobs" : "Hostile clocks",
                        "--hostile 100000",
                        {},
                        {},
                        "",
                        {}});
      if (jobs) others.back().random = job_sweep;
      found.push_back(&others.back());
    }
    return found;
  }();
  return all;
}

Planned planned(const DesignSweeps& design, const std::vector<const AnyBench*>& benches,
                const Asked& asked) {
  Planned all;
  for (const AnyBench* bench : benches) {
    std::vector<Sweep> sweeps;
    if (asked.exhaustive) sweeps = design.exhaustive(*bench, asked.lanes);
    if (asked.random != 0) sweeps = {design.random(*bench, asked.seed, asked.random)};
    if (asked.hostile != 0) sweeps = {hostile_sweep(*bench, asked.seed, asked.hostile)};
    for (Sweep& sweep : sweeps) {
      if (asked.lanes && asked.hostile == 0 && !sweep.in_lanes) {
        throw InputError(fmt::format("{}, {}: its jobs are driven one case at a time, not in lanes",
                                     bench->title(), sweep.name));
      }
      all.emplace_back(bench, std::move(sweep));
    }
  }
  return all;
}

Sweep interruptible(const Sweep& sweep, const std::function<void(const Result&)>& ran) {
  const auto told = [ran](Result result) {
    if (ran) ran(result);
    return result;
  };
  Sweep all = sweep;
  all.run = [run = sweep.run, told](std::uint64_t i) {
    InterruptGuard::check();
    Result one = run(i);
    one.cases = 1;
    return told(std::move(one));
  };
  if (!sweep.run_some) return all;
  all.run_some = [run = sweep.run_some, told](std::uint64_t first, std::uint64_t count) {
    InterruptGuard::check();
    return told(run(first, count));
  };
  return all;
}

}  // namespace cosim::cli

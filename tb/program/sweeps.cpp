#include "tb/program/sweeps.h"

#include <deque>
#include <set>

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

}  // namespace cosim::cli

#include "tb/mutation/cases.h"

#include "tb/stream/bench.h"

namespace cosim::mutation {
namespace {

Cases stream_cases(const AnyStreamBench& bench) {
  Cases cases;
  for (std::uint64_t i = 0; i < thorough_cases; ++i) {
    Case& one = cases.all.emplace_back();
    one.name = fmt::format("random transactions, case {}", i);
    one.finding_on = [&bench, i](StreamDut& rtl) {
      return bench.finding_on(rtl, {campaign_seed, i, 1000});
    };
  }
  cases.quick = quick_cases;
  return cases;
}

}  // namespace

Cases cases_of(const AnyBench& bench) {
  if (const auto* streams = dynamic_cast<const AnyStreamBench*>(&bench)) {
    return stream_cases(*streams);
  }
  Cases cases;
  const auto add = [&](std::uint64_t first, std::uint64_t last) {
    for (std::uint64_t i = first; i < last; ++i) {
      cases.all.push_back(hostile(bench, i));
      if (!bench.job_fields().empty()) cases.all.push_back(declared(bench, i));
    }
  };
  add(0, quick_cases);
  add_disturbed(cases.all, bench, 0, quick_disturbed);
  cases.quick = cases.all.size();
  add(quick_cases, thorough_cases);
  add_disturbed(cases.all, bench, quick_disturbed, thorough_cases);
  return cases;
}

}  // namespace cosim::mutation

#include "tb/cli/conclude.h"

#include <fmt/core.h>

#include <cstdio>

#include "model/core/input_error.h"
#include "tb/report/failure.h"
#include "tb/support/words.h"

namespace cosim::cli {

std::string drawn(const Result& result) {
  std::string text;
  for (const Measure& measure : result.checked.measures) {
    if (result.mismatch && measure.sum != Measure::Sum::total) continue;
    text += (text.empty() ? "" : ", ") + to_text(measure);
  }
  if (text.empty()) text = count(result.clocks, "clock");
  return text + (result.mismatch ? " before the first difference" : "");
}

namespace {

// The verdict holds even if the failure cannot be kept.
void keep_failure(const std::vector<Outcome>& outcomes, const Common& common) {
  if (!common.keeps_failures && !common.failures) return;
  for (const Outcome& o : outcomes) {
    if (!o.result.mismatch) continue;
    std::fflush(stdout);
    try {
      const FailureOptions options{common.failures_folder(), common.window()};
      fmt::print("\n{}",
                 to_text(leave_failure(*o.bench, o.result.failed, *o.result.mismatch, options)));
    } catch (const InputError& error) {
      complain(fmt::format("the failure is not kept: {}", error.what()));
    }
    return;
  }
}

}  // namespace

int conclude(const std::vector<Outcome>& outcomes, const Common& common, const std::string& extra) {
  fmt::print("{}{}", comparison_text(outcomes), verdict_text(outcomes));
  write_report(common.report.value_or(""), report_json(outcomes, common.seed(), extra));
  keep_failure(outcomes, common);
  return all_match(outcomes) ? 0 : 1;
}

}  // namespace cosim::cli

#include "tb/cli/conclude.h"

#include <fmt/format.h>

#include "tb/cli/words.h"

namespace cosim::cli {

std::string drawn(const Result& result) {
  const std::string steps = count(result.checked.steps, "step");
  // The oracle measures what is drawn to its end.
  if (result.mismatch) return steps + " before the first difference";
  return steps + ", largest deviation " + in_steps(result.checked.max_deviation);
}

int conclude(const std::vector<Outcome>& outcomes, const Common& common, const std::string& extra) {
  fmt::print("{}{}", comparison_text(outcomes), verdict_text(outcomes));
  write_report(common.report.value_or(""), report_json(outcomes, common.seed(), extra));
  return all_match(outcomes) ? 0 : 1;
}

}  // namespace cosim::cli

#include "tb/cli/conclude.h"

#include <fmt/core.h>

#include <cstdio>

#include "model/core/input_error.h"
#include "tb/sim/failure.h"
#include "tb/util/output_file.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

// The verdict holds even if the failure cannot be kept. The page of what is kept, or "".
std::string keep_failure(const std::vector<Outcome>& outcomes, const Common& common) {
  if (!common.keeps_failures && !common.failures) return "";
  for (const Outcome& o : outcomes) {
    if (!o.result.mismatch) continue;
    std::fflush(stdout);
    try {
      const FailureOptions options{common.failures_folder(), common.window()};
      const Failure failure = leave_failure(*o.bench, o.result.failed, *o.result.mismatch, options);
      fmt::print("\n{}", to_text(failure));
      return failure.page;
    } catch (const InputError& error) {
      complain(fmt::format("the failure is not kept: {}", error.what()));
    }
    return "";
  }
  return "";
}

}  // namespace

int conclude(const std::vector<Outcome>& outcomes, const Common& common, const std::string& extra,
             Looks looks, const std::string& title) {
  fmt::print("{}{}", comparison_text(outcomes), verdict_text(outcomes));
  write_report(common.report.value_or(""), report_json(outcomes, common.seed(), extra));
  const std::string kept = keep_failure(outcomes, common);
  if (common.html) {
    if (common.plot) {
      looks.push_back({"The path over the curve"});
      looks.back().image = *common.plot;
    }
    write_file(*common.html,
               kept.empty() ? page_text({outcomes, std::move(looks), {}, title}) : kept);
    fmt::print("page: {}\n", one_line(*common.html));
  }
  if (!all_match(outcomes)) return 1;
  int status = 0;
  for (const Outcome& o : outcomes) {
    if (common.allows_nothing || !compared_nothing(o)) continue;
    complain(nothing_text(o));
    status = 2;
  }
  return status;
}

}  // namespace cosim::cli

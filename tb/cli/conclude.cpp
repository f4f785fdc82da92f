#include "tb/cli/conclude.h"

#include <fmt/core.h>

#include <cstdio>

#include "model/core/input_error.h"
#include "tb/report/failure.h"
#include "tb/report/page.h"
#include "tb/support/output_file.h"
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

std::string page_of(const std::vector<Outcome>& outcomes, const Pictures& pictures) {
  Page page{outcomes};
  for (const WavePicture& picture : pictures) {
    page.parts.push_back({pictures.size() > 1 ? "The wave of " + picture.title : "The wave"});
    page.parts.back().picture = picture;
  }
  return page_text(page);
}

}  // namespace

int conclude(const std::vector<Outcome>& outcomes, const Common& common, const std::string& extra,
             const Pictures& pictures) {
  fmt::print("{}{}", comparison_text(outcomes), verdict_text(outcomes));
  write_report(common.report.value_or(""), report_json(outcomes, common.seed(), extra));
  const std::string kept = keep_failure(outcomes, common);
  if (common.html) {
    OutputFile file(*common.html);
    file.text(kept.empty() ? page_of(outcomes, pictures) : kept);
    file.close();
    fmt::print("page: {}\n", one_line(*common.html));
  }
  return all_match(outcomes) ? 0 : 1;
}

}  // namespace cosim::cli

#include "tb/sim/failure.h"

#include <fmt/core.h>

#include <cctype>

#include "model/core/input_error.h"
#include "tb/sim/page.h"
#include "tb/sim/report.h"
#include "tb/sim/shrink.h"
#include "tb/sim/stimulus_text.h"
#include "tb/util/draft.h"
#include "tb/util/json.h"
#include "tb/util/output_file.h"
#include "tb/util/quoted.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

// Of the folder: another one where a program that reads it has to know.
constexpr int format = 1;

std::string rows_text(const AnyBench& bench, std::size_t rows) {
  return fmt::format("{} {}{}", rows, bench.row(), rows == 1 ? "" : "s");
}

std::vector<Page::Command> commands_after(const Failure& failure) {
  const std::string folder = failure.folder.string();
  const std::string replay =
      fmt::format("{} replay {}/smallest.stim", for_shell(program_call()), folder);
  return {
      {failure.replay, "The same run once more"},
      {replay, "The smallest stimulus"},
      {replay + " --html again.html", "A page of it like this one, after a change"},
      {fmt::format("{} wave {}", for_shell(program_call()), folder), "The whole wave in GTKWave"},
      {fmt::format("cd {} && gtkwave wave.fst wave.gtkw", folder),
       "The same where there is only the folder"}};
}

}  // namespace

std::string failure_name(const AnyBench& bench, const std::string& what) {
  constexpr std::size_t longest = 60;
  std::string name;
  for (const char c : bench.title() + "-" + what) {
    if (c == '=') continue;
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.';
    if (plain) name += c;
    if (!plain && !name.empty() && name.back() != '-') name += '-';
  }
  name.resize(std::min(name.size(), longest));
  while (!name.empty() && !std::isalnum(static_cast<unsigned char>(name.back()))) name.pop_back();
  return name;
}

Failure leave_failure(const AnyBench& bench, const std::string& what, const Mismatch& mismatch,
                      const FailureOptions& options) {
  Draft draft(options.root, failure_name(bench, what));
  Failure failure;
  failure.folder = draft.target();
  failure.replay = fmt::format("{} replay {}", for_shell(program_call()), draft.target().string());

  Stimulus stimulus = mismatch.stimulus;
  stimulus.machine = bench.title();
  stimulus.origin = what;
  draft.write("stimulus.stim", to_text(stimulus, bench));
  const WavePicture wave =
      bench.draw_wave((draft.folder() / "wave.fst").string(), stimulus, options.wave);

  SmallerCase smallest{"", stimulus};
  if (mismatch.smaller_case) smallest = mismatch.smaller_case();
  smallest.stimulus.machine = bench.title();
  smallest.stimulus = shrink(bench, smallest.stimulus);
  smallest.stimulus.origin = "the smallest found of: " + what;
  const std::string smallest_text = to_text(smallest.stimulus, bench);
  draft.write("smallest.stim", smallest_text);
  const WavePicture smallest_wave =
      bench.draw_wave((draft.folder() / "smallest.fst").string(), smallest.stimulus, options.wave);
  const Run again = bench.replay(smallest.stimulus);

  if (!smallest.what.empty()) {
    failure.smallest = fmt::format("smallest case that still fails: {}\n", smallest.what);
  }
  failure.smallest += fmt::format("smallest stimulus that still fails: {}, smallest.stim\n",
                                  rows_text(bench, smallest.stimulus.clocks.size()));

  Outcome outcome{&bench, what, {}};
  outcome.result.cases = 1;
  outcome.result.clocks = mismatch.clock + 1;
  outcome.result.mismatch = mismatch;
  outcome.result.failed = what;
  draft.write("report.txt",
              fmt::format("{}\n{}{}\nreplay: {}\n", verdict_text({outcome}), failure.smallest,
                          again.mismatch ? to_text(*again.mismatch) : "", failure.replay));
  failure.page = page_text(
      {{outcome},
       {{"The wave around the first difference",
         "wave.fst has more clocks, and the RTL's whole hierarchy.", wave},
        {"The smallest stimulus that still fails", failure.smallest, smallest_wave, smallest_text}},
       commands_after(failure)});
  draft.write("report.html", failure.page);
  Json more;
  more["format"] = format;
  more["replay"] = failure.replay;
  more["smallest_case"] = smallest.what;
  more[fmt::format("smallest_{}s", bench.row())] = smallest.stimulus.clocks.size();
  write_report((draft.folder() / "report.json").string(),
               report_json({outcome}, stimulus.power_up, json_text(more)));
  draft.finish_replacing();
  return failure;
}

std::string to_text(const Failure& failure) {
  return fmt::format("{}kept in: {}\nreplay: {}\n", failure.smallest, failure.folder.string(),
                     failure.replay);
}

}  // namespace cosim

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <utility>

#include "model/core/input_error.h"
#include "tb/cli/commands.h"
#include "tb/cli/common.h"
#include "tb/cli/conclude.h"
#include "tb/cli/extent.h"
#include "tb/cli/outputs.h"
#include "tb/cli/wave.h"
#include "tb/sim/stimulus_text.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

struct ReplayOptions {
  Common common;
  Text file;
};

int run(const ReplayOptions& o) {
  std::string file = *o.file;
  if (file.empty()) throw InputError("FILE: names no file");
  if (std::filesystem::is_directory(file)) {
    file = (std::filesystem::path(file) / "stimulus.stim").string();
  }
  const auto [bench, stimulus] = read_stimulus(file, benches());
  check_extent(o.common, {stimulus.clocks.size(), 0, 0, 0});
  check_outputs(o.common, {file}, {bench});

  const std::string& work = stimulus.origin.empty() ? file : stimulus.origin;
  fmt::print("{}: {}, {}\n", bench->title(), one_line(file),
             count(stimulus.clocks.size(), bench->row()));
  const Looks looks = draw_wave(o.common, *bench, stimulus, work);
  Run run = bench->replay(stimulus);
  run.happened.clear();  // that most cases do not happen in one stimulus means nothing
  Result result = result_of(std::move(run), {}, work);
  return conclude({{bench, file, std::move(result)}}, o.common, "{}", looks);
}

}  // namespace

void add_replay(const Command& program) {
  auto o = std::make_shared<ReplayOptions>();
  const Command command =
      program.sub("replay", "Runs a stimulus file, or the folder of a failure, again");
  command.argument("FILE", o->file, "The stimulus, or a folder that holds a stimulus.stim", true);
  add_wave(command, o->common, "Draw it as a waveform, with FILE.gtkw, its view for GTKWave");
  add_failures(command, o->common, false);
  add_report(command, o->common);
  add_allow_nothing(command, o->common);
  command.footer(fmt::format("Example: {} replay failures/NAME/smallest.stim --wave again.fst",
                             program_name()));
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli

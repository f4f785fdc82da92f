// PROGRAM program: files that a stream model reads, such as test programs of a processor.
#include <fmt/core.h>

#include <memory>
#include <utility>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/cli/commands.h"
#include "tb/cli/common.h"
#include "tb/cli/conclude.h"
#include "tb/cli/outputs.h"
#include "tb/cli/verdicts.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

struct ProgramOptions {
  Common common;
  std::vector<std::string> words;
};

// Whatever becomes of a program, the next one runs; a file that cannot be read ends all.
int run(const ProgramOptions& o, Verdicts& verdicts) {
  const auto [bench, first] = bench_before(o.words);
  if (!bench->has_programs()) {
    throw InputError(bench->title() + ": its model has no program(), which reads a file");
  }
  const std::vector<std::string> files(o.words.begin() + static_cast<std::ptrdiff_t>(first),
                                       o.words.end());
  if (files.empty()) throw InputError("FILE: is needed");
  check_outputs(o.common, files);
  std::vector<Outcome> outcomes;
  for (const std::string& file : files) {
    Checked checked;
    checked.jobs = 1;
    const Stimulus stimulus = bench->program(file, o.common.seed(), checked.error);
    const std::string work = one_line(file);
    outcomes.push_back({bench, work, result_of(bench->replay(stimulus), checked, work)});
    verdicts.add(outcomes.back(), o.common.allows_nothing);
    fmt::print("{}, {}: {}, {}\n", bench->title(), work,
               count(stimulus.clocks.size(), bench->row()),
               outcomes.back().result.match() ? "match" : "MISMATCH");
  }
  return conclude(outcomes, o.common);
}

}  // namespace

void add_program(const Command& program) {
  std::string design;
  for (const auto& bench : benches()) {
    if (bench->has_programs() && design.empty()) design = bench->design();
  }
  if (design.empty()) return;
  auto o = std::make_shared<ProgramOptions>();
  const Command command = program.sub(
      "program", "Runs files that a stream model reads, such as test programs of a processor");
  command.arguments(
      "DESIGN FILE...", o->words,
      "The design and values of its parameters; then the files. --seed S draws other\n"
      "stalls");
  add_junit(command, o->common);
  add_failures(command, o->common);
  add_html(command, o->common, "the figures or the first failure");
  add_common(command, o->common);
  command.footer(fmt::format("Example: {} program {} a.elf b.elf", program_name(), design));
  command.action([o] {
    return with_verdicts("program", o->words.empty() ? "" : o->words.front(), o->common,
                         [&](Verdicts& verdicts) { return run(*o, verdicts); });
  });
}

}  // namespace cosim::cli

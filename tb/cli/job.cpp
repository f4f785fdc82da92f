// PROGRAM job: one declared job, or several, from the command line.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/cli/commands.h"
#include "tb/cli/common.h"
#include "tb/cli/conclude.h"
#include "tb/cli/extent.h"
#include "tb/cli/outputs.h"
#include "tb/cli/wave.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

struct JobOptions {
  Common common;
  std::vector<std::string> words;
};

// "idle, 0 to 40: clocks before it"
std::string described(const JobField& f) {
  return fmt::format("{}, {} to {}: {}", f.name, f.low, f.high, f.meaning);
}

// The values of one job: NAME=VALUE for each field, those that are not named at their simplest.
std::vector<Word> values_of(const std::vector<JobField>& fields, const std::string& text) {
  std::vector<Word> values;
  for (const JobField& f : fields) values.push_back(simplest(f));
  std::vector<bool> given(fields.size());
  for (const std::string& word : words_in(text)) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const auto field = std::ranges::find(fields, word.substr(0, equals), &JobField::name);
    if (field == fields.end()) {
      std::string names;
      for (const JobField& f : fields) names += (names.empty() ? "" : ", ") + std::string(f.name);
      throw InputError(fmt::format("{} is no field of a job and its value; there are {}",
                                   in_quotes(word), names));
    }
    const auto at = static_cast<std::size_t>(field - fields.begin());
    if (given[at]) throw InputError(fmt::format("{}: is given more than once", field->name));
    given[at] = true;
    const std::string digits = equals == word.size() ? "" : word.substr(equals + 1);
    std::istringstream number(digits);
    Word value = 0;
    if (!(number >> value) || !number.eof() || value < field->low || value > field->high) {
      throw InputError(fmt::format("{}: {} is no number from {} to {}", field->name,
                                   in_quotes(digits), field->low, field->high));
    }
    values[at] = value;
  }
  return values;
}

// The design and its parameters, then what is behind them: the jobs, a semicolon between two.
std::pair<const AnyBench*, JobList> read(const std::vector<std::string>& words) {
  const auto [bench, at] = bench_before(words);
  const auto fields = bench->job_fields();
  if (fields.empty()) throw InputError(bench->design() + ": declares no jobs");
  const auto begin = words.begin() + static_cast<std::ptrdiff_t>(at);
  const std::string text = fmt::format("{}", fmt::join(begin, words.end(), " "));
  JobList jobs;
  for (const std::string& part : parts_in(text, ';')) jobs.push_back(values_of(fields, part));
  if (jobs.empty()) jobs.push_back(values_of(fields, ""));
  return {bench, jobs};
}

int run(const JobOptions& o) {
  const auto [bench, jobs] = read(o.words);
  const auto power_up = static_cast<std::uint32_t>(o.common.seed());
  const Stimulus stimulus = bench->stimulus_of(jobs, power_up);
  check_extent(o.common, {stimulus.clocks.size(), 0, 0, 0});
  check_outputs(o.common, {}, {bench});
  const std::string work = bench->describe(jobs);
  fmt::print("{}: {}\n", bench->title(), work);
  const Looks looks = draw_wave(o.common, *bench, stimulus, work);
  JobsRun ran = bench->run_jobs(jobs, power_up);
  Result result = result_of(std::move(ran.run), std::move(ran.checked), work);
  return conclude({{bench, work, std::move(result)}}, o.common, "{}", looks);
}

}  // namespace

void add_job(const Command& program) {
  std::string fields, example;
  std::string design;
  for (const auto& bench : benches()) {
    if (bench->design() == design || bench->job_fields().empty()) continue;
    design = bench->design();
    fields += fmt::format("The fields of {}:\n", design);
    for (const JobField& f : bench->job_fields()) fields += "  " + described(f) + '\n';
    if (!example.empty()) continue;
    for (const JobField& f : bench->job_fields()) example += fmt::format(" {}={}", f.name, f.high);
    example = design + example;
  }
  if (example.empty()) return;
  auto o = std::make_shared<JobOptions>();
  const Command command =
      program.sub("job", "Runs a job of a design, or several, one after the other");
  command.arguments("DESIGN WORD...", o->words,
                    "The design and values of its parameters; then the fields of the job, each\n"
                    "NAME=VALUE, 0 where not given. A ';' separates jobs");
  add_wave(command, o->common, "Draw the run as a waveform, with FILE.gtkw, its view for GTKWave");
  add_failures(command, o->common);
  add_common(command, o->common);
  command.footer(fmt::format("{}Example: {} job {}", fields, program_name(), example));
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli

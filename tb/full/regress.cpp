// PROGRAM regress: a regression, written once, on this host's cores or on a cluster's.
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "model/core/input_error.h"
#include "tb/cli/number.h"
#include "tb/cli/verdicts.h"
#include "tb/full/commands.h"
#include "tb/full/regress_kinds.h"
#include "tb/regress/local.h"
#include "tb/regress/slurm.h"
#include "tb/regress/worker.h"
#include "tb/util/file_lock.h"
#include "tb/util/interrupt.h"
#include "tb/util/json.h"
#include "tb/util/parallel.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

// What a regression says while it runs, and before.
/// How far a run is: one line that redraws itself on a terminal, elsewhere a line a minute and one
/// for each shard that fails.
class RegressProgress {
 public:
  RegressProgress();
  void show(const regress::Tally& tally);
  /// Takes the line away.
  void clear();

 private:
  using Time = std::chrono::steady_clock;
  std::string text(const regress::Tally& tally) const;

  bool terminal_, drawn_ = false;
  Time::time_point began_ = Time::now(), due_ = began_ + std::chrono::minutes(1);
  double minutes_before_ = -1;  // done when it began
  std::uint64_t failed_ = 0;
};

// "50 s", "12 min", "3.5 h"
std::string duration(double minutes) {
  if (minutes < 1.5) return fmt::format("{:.0f} s", 60 * minutes);
  return minutes < 120 ? fmt::format("{:.0f} min", minutes) : fmt::format("{:.1f} h", minutes / 60);
}

// What would run, how it is cut and how long that is expected to take, lines.
std::string dry_run_text(const regress::Plan& plan, const std::vector<regress::Known>& works,
                         std::uint64_t shards, unsigned jobs) {
  const auto cuts = regress::cut(regress::sizes(works), shards);
  std::string text = fmt::format("{}: seed {}\n{:>12} {:>7} {:>8}  work\n", plan.name, plan.seed,
                                 "units", "shards", "time");
  double minutes = 0;
  for (std::size_t w = 0; w < works.size(); ++w) {
    const regress::Size& size = works[w].size;
    const auto parts = std::ranges::count(cuts, w, &regress::Shard::work);
    text += fmt::format("{:>12} {:>7} {:>8}  {}: {}\n", size.units, parts, duration(size.minutes),
                        plan.tasks[works[w].task].name, works[w].title);
    minutes += size.minutes;
  }
  return text + fmt::format("{}, {}: expected to take {} of processor time, {} on {}\n",
                            count(works.size(), "work"), count(cuts.size(), "shard"),
                            duration(minutes), duration(minutes / jobs), count(jobs, "core"));
}

RegressProgress::RegressProgress() : terminal_(isatty(STDOUT_FILENO) == 1) {}

std::string RegressProgress::text(const regress::Tally& t) const {
  std::string text = fmt::format("{} of {} done, {} running, {} waiting, {} failed", t.done,
                                 count(t.shards, "shard"), t.running, t.waiting(), t.failed);
  if (t.errors != 0) text += fmt::format(", {} could not be run", t.errors);
  const std::chrono::duration<double, std::ratio<60>> gone = Time::now() - began_;
  const double done = t.done_minutes - minutes_before_;
  if (done > 0) {
    text += ", " + duration(gone.count() * (t.minutes - t.done_minutes) / done) + " left";
  }
  return text;
}

void RegressProgress::show(const regress::Tally& tally) {
  if (minutes_before_ < 0) minutes_before_ = tally.done_minutes;
  if (terminal_) {
    fmt::print("\r{:.79}\x1b[K", text(tally));
    drawn_ = true;
  } else if (tally.failed > failed_ || Time::now() >= due_) {
    fmt::print("{}\n", text(tally));
    due_ = Time::now() + std::chrono::minutes(1);
  }
  failed_ = tally.failed;
  std::fflush(stdout);
}

void RegressProgress::clear() {
  if (drawn_) fmt::print("\r\x1b[K");
  drawn_ = false;
}

// A line each for the reasons why shards could not be run, those of equal ones together.
std::vector<std::string> lines_of(const regress::Errors& errors) {
  std::map<std::string, std::vector<std::uint64_t>> by_text;
  for (const auto& [shard, text] : errors) by_text[text].push_back(shard);
  std::vector<std::string> lines;
  for (const auto& [text, shards] : by_text) {
    lines.push_back(fmt::format("shard{} {}: {}", shards.size() == 1 ? "" : "s",
                                regress::list_of(shards), text));
  }
  return lines;
}

namespace fs = std::filesystem;
using regress::RunFolder;

struct RegressOptions {
  Text file, folder, resume, shards, jobs, seed, sbatch, work, only, list;
  Common common;
  bool dry_run = false, fail_fast = false, schema = false, slurm = false, merge = false;
};

unsigned jobs_of(const RegressOptions& o) {
  return o.jobs ? static_cast<unsigned>(whole("--jobs", *o.jobs, 1, 1024)) : cores();
}

// Another one for every run, and short enough to be typed again.
std::uint64_t new_seed() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::seconds>(now).count());
}

// The plan and its works; none where something is wrong with it, which is then said.
std::optional<std::pair<regress::Plan, std::vector<regress::Known>>> planned(
    const RegressOptions& o, const regress::Kinds& kinds) {
  const std::uint64_t seed = o.seed ? whole("--seed", *o.seed, 0, ~std::uint64_t{0}) : new_seed();
  std::vector<std::string> errors;
  auto plan = regress::read_plan(read_file(*o.file), *o.file, keys_of(kinds), seed, errors);
  if (o.seed && plan.seed != seed) {
    throw InputError(fmt::format("--seed: {} has a seed of its own, {}", *o.file, plan.seed));
  }
  std::vector<regress::Known> works;
  if (errors.empty()) {
    works = known_works(plan, kinds, fs::path(*o.file).parent_path(), *o.file, errors);
  }
  for (const std::string& line : errors) complain(line);
  if (!errors.empty()) return std::nullopt;
  return std::pair{std::move(plan), std::move(works)};
}

// NAME-1, NAME-2, ... in the folder `regressions`.
fs::path free_folder(const std::string& name) {
  std::string plain;
  for (const char c : name) plain += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
  for (int i = 1;; ++i) {
    fs::path folder = fs::path("regressions") / fmt::format("{}-{}", plain, i);
    if (!fs::exists(folder)) return folder;
  }
}

// "account=x nice" as sbatch takes them.
std::vector<std::string> sbatch_options(const RegressOptions& o) {
  std::vector<std::string> options = words_in(o.sbatch.value_or(""));
  for (std::string& one : options) one.insert(0, one.starts_with("-") ? "" : "--");
  return options;
}

std::string resume_line(const RunFolder& run) {
  return fmt::format("go on with: {} regress --resume {}\n", one_line(run.program().string()),
                     one_line(run.path().string()));
}

// A verdict of each work.
void add_verdicts(const Json& report, Verdicts& verdicts) {
  using enum ci::Verdict::End;
  for (const Json& task : report["tasks"]) {
    for (const Json& work : task["works"]) {
      const auto text_at = [](const Json& json, const char* key) {
        return json.at(key).get<std::string>();
      };
      const std::string verdict = text_at(work, "verdict");
      const std::string name = text_at(task, "name") + ": " + text_at(work, "title");
      ci::Verdict one{name,
                      verdict == "pass"   ? passed
                      : verdict == "fail" ? failure
                                          : error,
                      verdict, ""};
      for (const Json& failure : report["failures"]) {
        if (text_at(failure, "work") == name) one.text += text_at(failure, "what") + '\n';
      }
      if (one.text.empty()) one.text = verdict;
      verdicts.add(one);
    }
  }
}

// Ends a run whose shards are over, for now.
int conclude_run(const RunFolder& run, const regress::Kinds& kinds, const regress::Errors& errors,
                 Verdicts& verdicts) {
  const auto results =
      regress::read_results(run.path() / "results", run.identity(), run.shards().size());
  const regress::Report report = regress::report(run, kinds, results);
  write_report(run, results, report);
  add_verdicts(report.json, verdicts);
  for (const std::string& line : lines_of(errors)) complain(line);
  fmt::print("{}report: {}\n", report.text, one_line((run.path() / "report.json").string()));
  if (report.holds) return 0;
  if (report.json["verdict"] == "unfinished") fmt::print("{}", resume_line(run));
  return report.json["failures"].empty() ? 2 : 1;
}

int carry_out(const RunFolder& run, const RegressOptions& o, const regress::Kinds& kinds,
              Verdicts& verdicts) {
  const FileLock lock(run.path() / "lock", FileLock::Held::kRefuse);
  RegressProgress progress;
  const regress::Tell tell = [&](const regress::Tally& tally) { progress.show(tally); };
  try {
    const regress::Errors errors =
        o.slurm ? run_slurm(run, kinds, {sbatch_options(o), o.fail_fast, tell})
                : run_local(run, kinds, {jobs_of(o), o.fail_fast, tell});
    progress.clear();
    return conclude_run(run, kinds, errors, verdicts);
  } catch (const Interrupted& interrupted) {
    progress.clear();
    const auto results =
        regress::read_results(run.path() / "results", run.identity(), run.shards().size());
    fmt::print("interrupted: {} of {} done\n{}", results.finished(),
               count(run.shards().size(), "shard"), resume_line(run));
    return 128 + interrupted.signal;
  }
}

int new_run(const RegressOptions& o, const regress::Kinds& kinds, Verdicts& verdicts) {
  auto known = planned(o, kinds);
  if (!known) return 2;
  auto& [plan, works] = *known;
  const std::uint64_t shards =
      o.shards ? whole("--shards", *o.shards, 1, regress::most_shards) : usual_shards(sizes(works));
  const unsigned jobs = jobs_of(o);
  if (o.dry_run) {
    fmt::print("{}", dry_run_text(plan, works, shards, jobs));
    return 0;
  }
  const fs::path folder = o.folder ? fs::path(*o.folder) : free_folder(plan.name);
  const fs::path plan_folder = fs::path(*o.file).parent_path();
  const RunFolder run =
      RunFolder::make(folder, std::move(plan), kinds, plan_folder, shards, o.slurm);
  fmt::print("{}: seed {}, {} in {}\n", run.plan().name, run.plan().seed,
             count(run.shards().size(), "shard"), one_line(run.path().string()));
  std::fflush(stdout);
  return carry_out(run, o, kinds, verdicts);
}

// What the processes of a run do.
int work(const RegressOptions& o, const regress::Kinds& kinds, Verdicts& verdicts) {
  if ((o.only ? 1 : 0) + (o.list ? 1 : 0) + (o.merge ? 1 : 0) != 1) {
    throw InputError("--work: needs one of --only, --list and --merge");
  }
  const RunFolder run(*o.work, kinds);
  if (o.merge) return conclude_run(run, kinds, {}, verdicts);
  if (o.list) return run_array_task(run, kinds, *o.list);
  const auto shards = regress::shards_in(*o.only, run.shards().size(), "--only");
  return run_shards(run, kinds, shards, regress::host());
}

int run(const RegressOptions& o, const Registry& registry, Verdicts& verdicts) {
  const InterruptGuard interrupts;
  const regress::Kinds kinds = regress_kinds(registry);
  if (o.schema) {
    fmt::print("{}\n", json_text(schema(keys_of(kinds)), 1));
    return 0;
  }
  if (o.work) return work(o, kinds, verdicts);
  if (o.only || o.list || o.merge) throw InputError("--only, --list and --merge go with --work");
  if (o.sbatch && !o.slurm) throw InputError("--sbatch: goes with --slurm");
  if (o.jobs && o.slurm) throw InputError("--jobs: does not go with --slurm; the cluster decides");
  if (o.file.has_value() == o.resume.has_value()) {
    throw InputError("regress: needs a FILE, or --resume FOLDER");
  }
  if (o.file) return new_run(o, kinds, verdicts);
  if (o.folder || o.shards || o.seed || o.dry_run) {
    throw InputError(
        "--resume: continues the run as it began, without --folder, --shards, --seed and "
        "--dry-run");
  }
  jobs_of(o);
  return carry_out(RunFolder(*o.resume, kinds), o, kinds, verdicts);
}

}  // namespace

void add_regress(const Command& program, const Registry& registry) {
  auto o = std::make_shared<RegressOptions>();
  const Command command = program.sub(regress_command.name, regress_command.help);
  command.argument("FILE", o->file, "The plan, a JSON file; --schema prints its format");
  command.text("--folder", o->folder, "DIR",
               "A new folder for the run; default regressions/NAME-NUMBER");
  command.text("--resume", o->resume, "DIR", "Resume the run in DIR");
  command.text("--shards", o->shards, "N",
               "About N parts; default a minute each. The report stays the same");
  command.text("--jobs", o->jobs, "J", "Parts at a time, 1 to 1024; default one a core");
  command.text("--seed", o->seed, "S",
               "Seed of the run; default a new one each time, which is printed");
  command.flag("--fail-fast", o->fail_fast, "Begin no part after one that fails");
  command.flag("--slurm", o->slurm, "On the nodes of a Slurm cluster; DIR on a disk they share");
  command.text("--sbatch", o->sbatch, "WORDS",
               "More options for sbatch: 'account=x partition=y nice'");
  command.flag("--dry-run", o->dry_run, "Only print what would run, in which parts");
  command.flag("--schema", o->schema, "Only print the plan's JSON Schema, for editors");
  command.text("--work", o->work, "DIR",
               "Only work on parts of the run in DIR, with one of these three:");
  command.text("--only", o->only, "LIST", "With --work: these parts, such as 0-3,7");
  command.text("--list", o->list, "FILE",
               "With --work: the parts on one line of FILE, that of this task of a job array");
  command.flag("--merge", o->merge, "With --work: no part, only put the report together");
  add_junit(command, o->common);
  command.footer(
      "A killed run is resumed by --resume and ends with the same report.json.\n"
      "Exit status: 0 all holds, 1 something does not, 2 bad input, or not all could be run.\n"
      "Example: " +
      program_name() + " regress --schema");
  command.action([o, &registry] {
    return with_verdicts(regress_command.name, regress_command.name, o->common,
                         [&](Verdicts& verdicts) { return run(*o, registry, verdicts); });
  });
}

}  // namespace cosim::cli

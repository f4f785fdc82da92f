#include "tb/regress/slurm.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "model/core/input_error.h"
#include "tb/regress/worker.h"
#include "tb/util/interrupt.h"
#include "tb/util/output_file.h"
#include "tb/util/process.h"
#include "tb/util/quoted.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::regress {
namespace {

// The queue of a Slurm cluster, by the commands that look at it and change it.
/// Numbers of jobs, as sbatch prints them.
using Jobs = std::vector<std::string>;

/// What is in the queue.
struct Queue {
  bool there = false;  ///< any of the jobs, or it cannot be asked at the moment
  std::uint64_t running = 0;
};

constexpr std::chrono::seconds moment(3);

std::string first_line(const std::string& text) {
  return one_line(text.substr(0, text.find('\n')));
}

// Runs an sbatch with --parsable; the number of the job. InputError where it refuses.
std::string submitted(const std::vector<std::string>& words) {
  const Ended ended = cosim::run_program(words);
  if (ended.status == 127) throw InputError("--slurm: there is no sbatch on this host");
  // "NUMBER" or "NUMBER;CLUSTER", behind what the cluster may say besides.
  std::string number;
  for (const std::string& line : lines_in(ended.text)) {
    const std::string word = line.substr(0, line.find(';'));
    const bool digits = word.find_first_not_of("0123456789") == std::string::npos;
    if (!word.empty() && digits) number = word;
  }
  if (ended.status == 0 && !number.empty()) return number;
  const std::string line = first_line(ended.text);
  throw InputError(line.starts_with("sbatch: ") ? line : "sbatch: " + line);
}

Queue in_queue(const Jobs& jobs) {
  const Ended asked = cosim::run_program({"squeue", "--noheader", "--array", "--format=%T",
                                          fmt::format("--jobs={}", fmt::join(jobs, ","))});
  // One job that is long over is an error to it; so is a controller that is away for a while.
  if (asked.status != 0) return {asked.text.find("Invalid job id") == std::string::npos, 0};
  Queue queue;
  for (const std::string& state : lines_in(asked.text)) {
    queue.there = true;
    queue.running += state == "RUNNING" ? 1 : 0;
  }
  return queue;
}

// Cancels those that are still there. Where that fails it says how to do it by hand.
void cancel(const Jobs& jobs) {
  if (jobs.empty()) return;
  std::vector<std::string> words{"scancel", "--quiet"};
  words.insert(words.end(), jobs.begin(), jobs.end());
  if (run_all_the_same(words).status == 0) return;
  complain(fmt::format("the jobs are not cancelled; do it with: scancel {}", fmt::join(jobs, " ")));
}

// Puts a job that is running back into the queue; not one that is being cancelled.
void put_back(const std::string& job) {
  // Of one that is cancelled the state is another one.
  const std::string commands = fmt::format(
      "test \"$(squeue --noheader --jobs={0} --format=%T)\" != RUNNING || scontrol requeue {0}",
      job);
  if (run_all_the_same({"sh", "-c", commands}).status != 0) complain("scontrol requeue failed");
}

// Waits for some seconds. Interrupted when a signal comes.
void wait_a_moment() {
  const auto end = std::chrono::steady_clock::now() + moment;
  while (std::chrono::steady_clock::now() < end) {
    InterruptGuard::check();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

namespace fs = std::filesystem;

// Many clusters allow 1001.
constexpr std::size_t most_tasks = 1000;

using Shards = std::vector<std::uint64_t>;

bool has_variable(const char* name) { return std::getenv(name) != nullptr; }

// By what its shards ask of a node.
std::map<std::uint64_t, Shards> by_memory(const RunFolder& run, const Shards& shards) {
  std::map<std::uint64_t, Shards> groups;
  for (const std::uint64_t s : shards) {
    groups[run.plan().tasks[run.works()[run.shards()[s].work].task].memory].push_back(s);
  }
  return groups;
}

// Parts of about as many shards, in their order.
std::vector<Shards> tasks_of(const Shards& shards) {
  const std::size_t tasks = std::min(most_tasks, shards.size());
  std::vector<Shards> all(tasks);
  for (std::size_t t = 0; t < tasks; ++t) {
    all[t].assign(shards.begin() + static_cast<std::ptrdiff_t>(shards.size() * t / tasks),
                  shards.begin() + static_cast<std::ptrdiff_t>(shards.size() * (t + 1) / tasks));
  }
  return all;
}

// Minutes for a task of the array: at its end it is only put back into the queue.
long time_limit(const RunFolder& run, const std::vector<Shards>& tasks) {
  double longest = 0;
  for (const Shards& shards : tasks) {
    double minutes = 0;
    for (const std::uint64_t s : shards) minutes += run.minutes(s);
    longest = std::max(longest, minutes);
  }
  return std::lround(10 + 4 * longest);
}

class Submission {
 public:
  Submission(const RunFolder& run, const SlurmOptions& options)
      : run_(run), options_(options), folder_(run.path() / "slurm") {
    std::error_code error;
    fs::create_directories(folder_, error);
  }

  /// What is there of an earlier submission.
  Jobs before() const {
    Jobs jobs;
    std::ifstream file(folder_ / "jobs.txt");
    for (std::string id; file >> id;) jobs.push_back(id);
    return jobs;
  }

  /// All jobs of these shards.
  Jobs submit(const Shards& shards) {
    try {
      for (const auto& [memory, some] : by_memory(run_, shards)) array(memory, some);
      merging();
    } catch (...) {
      give_up(jobs_);
      throw;
    }
    return jobs_;
  }

  /// Cancels the jobs; nobody is to wait for them any more.
  void give_up(const Jobs& jobs) const {
    cancel(jobs);
    std::error_code ignored;
    fs::remove(folder_ / "jobs.txt", ignored);
  }

 private:
  void array(std::uint64_t memory, const Shards& shards) {
    const std::vector<Shards> tasks = tasks_of(shards);
    const fs::path script = next_script();
    fs::path list = script;
    list.replace_extension(".txt");
    std::string lines;
    for (const Shards& one : tasks) lines += list_of(one) + '\n';
    write_file(list.string(), lines);
    std::vector<std::string> words{fmt::format("--array=0-{}", tasks.size() - 1),
                                   "--signal=B:TERM@120"};
    if (!has_variable("SBATCH_NO_REQUEUE")) words.emplace_back("--requeue");
    if (!has_variable("SBATCH_TIMELIMIT")) {
      words.push_back(fmt::format("--time={}", time_limit(run_, tasks)));
    }
    if (memory != 0) words.push_back(fmt::format("--mem={}M", memory));
    job(script, "%A_%a", words, "--list " + for_shell(list.string()));
  }

  void merging() {
    std::string after;
    for (const std::string& id : jobs_) after += ':' + id;
    job(next_script(), "%j", {"--dependency=afterany" + after}, "--merge");
  }

  // One whose name is free.
  fs::path next_script() const {
    for (int i = 1;; ++i) {
      fs::path script = folder_ / fmt::format("{}.sh", i);
      if (!fs::exists(script)) return script;
    }
  }

  // `more` are options of sbatch, `what` those of the program.
  void job(const fs::path& script, const std::string& log, const std::vector<std::string>& more,
           const std::string& what) {
    const std::string folder = run_.path().string();
    write_file(script.string(),
               fmt::format("#!/bin/sh\nexec {} regress --work {} {}\n",
                           for_shell(run_.program().string()), for_shell(folder), what));
    std::vector<std::string> words{"sbatch", "--parsable", "--open-mode=append",
                                   fmt::format("--output={}/logs/{}.txt", folder, log)};
    if (!has_variable("SBATCH_JOB_NAME")) {
      words.push_back("--job-name=" + program_name() + '-' + run_.path().filename().string());
    }
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), options_.sbatch.begin(), options_.sbatch.end());
    words.push_back(script.string());
    jobs_.push_back(submitted(words));
    write_file((folder_ / "jobs.txt").string(), fmt::format("{}\n", fmt::join(jobs_, "\n")));
  }

  const RunFolder& run_;
  const SlurmOptions& options_;
  fs::path folder_;
  Jobs jobs_;
};

// Of shards that are missing when all is over.
Errors errors_of(const RunFolder& run, const Results& results,
                 const std::vector<std::uint64_t>& left) {
  Errors errors(results.errors.begin(), results.errors.end());
  for (const std::uint64_t s : left) {
    errors.emplace(s, fmt::format("left no result; see {}", (run.path() / "logs").string()));
  }
  return errors;
}

std::string variable(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? "" : text;
}

}  // namespace

Errors run_slurm(const RunFolder& run, const Kinds& kinds, const SlurmOptions& options) {
  const fs::path folder = run.path() / "results";
  const std::uint64_t shards = run.shards().size();
  const std::vector<bool> ends = ends_at_failure(run, kinds);
  Results results = read_results(folder, run.identity(), shards);
  Submission submission(run, options);
  Jobs jobs = submission.before();
  if (jobs.empty() || !in_queue(jobs).there) {
    const Shards wanted = missing(run, results, ends);
    if (wanted.empty()) return {};
    jobs = submission.submit(wanted);
  }
  try {
    for (Queue queue = in_queue(jobs); queue.there; queue = in_queue(jobs)) {
      results = read_results(folder, run.identity(), shards);
      Tally tally = tally_of(run, results);
      tally.running = std::min(queue.running, tally.shards - tally.done - tally.errors);
      options.tell(tally);
      if (options.fail_fast && tally.failed != 0) {
        submission.give_up(jobs);
        return {};
      }
      wait_a_moment();
    }
  } catch (const Interrupted&) {
    submission.give_up(jobs);
    throw;
  }
  results = read_results(folder, run.identity(), shards);
  options.tell(tally_of(run, results));
  return errors_of(run, results, missing(run, results, ends));
}

int run_array_task(const RunFolder& run, const Kinds& kinds, const std::string& list) {
  const InterruptGuard interrupts;
  const std::string number = variable("SLURM_ARRAY_TASK_ID"), job = variable("SLURM_JOB_ID");
  if (number.empty() || job.empty()) throw InputError("--list: only in a task of a job array");
  std::ifstream file(list);
  std::string line;
  for (long i = std::strtol(number.c_str(), nullptr, 10); i >= 0; --i) std::getline(file, line);
  if (!file) throw InputError(fmt::format("{}: no line for task {}", list, number));
  const std::string restart = variable("SLURM_RESTART_COUNT");
  const std::uint64_t shards = run.shards().size();
  const Results results = read_results(run.path() / "results", run.identity(), shards);
  Shards wanted = shards_in(line, shards, list);
  std::erase_if(wanted, [&](std::uint64_t s) { return results.done[s].has_value(); });
  try {
    return run_shards(run, kinds, wanted,
                      fmt::format("slurm-{}-{}", job, restart.empty() ? "0" : restart));
  } catch (const Interrupted&) {
    put_back(job);
    throw;
  }
}

}  // namespace cosim::regress

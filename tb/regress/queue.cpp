#include "tb/regress/queue.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "model/core/input_error.h"
#include "tb/support/interrupt.h"
#include "tb/support/process.h"
#include "tb/support/words.h"

namespace cosim::regress {
namespace {

constexpr std::chrono::seconds moment(3);

std::string first_line(const std::string& text) {
  return one_line(text.substr(0, text.find('\n')));
}

}  // namespace

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

void cancel(const Jobs& jobs) {
  if (jobs.empty()) return;
  std::vector<std::string> words{"scancel", "--quiet"};
  words.insert(words.end(), jobs.begin(), jobs.end());
  if (run_all_the_same(words).status == 0) return;
  complain(fmt::format("the jobs are not cancelled; do it with: scancel {}", fmt::join(jobs, " ")));
}

void put_back(const std::string& job) {
  // Of one that is cancelled the state is another one.
  const std::string commands = fmt::format(
      "test \"$(squeue --noheader --jobs={0} --format=%T)\" != RUNNING || scontrol requeue {0}",
      job);
  if (run_all_the_same({"sh", "-c", commands}).status != 0) complain("scontrol requeue failed");
}

void wait_a_moment() {
  const auto end = std::chrono::steady_clock::now() + moment;
  while (std::chrono::steady_clock::now() < end) {
    InterruptGuard::check();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

}  // namespace cosim::regress

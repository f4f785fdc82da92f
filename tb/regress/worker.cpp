// A shard has a checkpoint, which is removed once its line is appended: a worker that is killed
// between the two leaves a shard that is run again. Its line is then there twice, and counts once.
#include "tb/regress/worker.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "model/core/input_error.h"
#include "tb/regress/results.h"
#include "tb/util/interrupt.h"
#include "tb/util/words.h"

namespace cosim::regress {
namespace {

namespace fs = std::filesystem;
using Time = std::chrono::steady_clock;

// A number of decimal digits alone at the beginning of `text`, which is then cut off.
std::uint64_t take_number(std::string& text, const InputError& wrong) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  if (digits == 0 || digits > 9) throw wrong;
  const std::uint64_t number = std::stoull(text.substr(0, digits));
  text.erase(0, digits);
  return number;
}

bool on_a_cluster() { return std::getenv("SLURM_JOB_ID") != nullptr; }

std::chrono::milliseconds pace() {
  return on_a_cluster() ? std::chrono::seconds(10) : std::chrono::milliseconds(100);
}

// Runs one shard and appends its line.
int run_shard(const RunFolder& run, const Work& work, std::uint64_t number,
              const fs::path& results) {
  const Shard& shard = run.shards()[number];
  const fs::path kept = run.path() / "checkpoints" / std::to_string(number);
  Line line{number, host(), 0, {}, ""};
  const auto began = Time::now();
  try {
    Checkpoint checkpoint(kept.string(), fmt::format("shard {} of {}", number, run.identity()),
                          pace());
    line.result = work.run(shard.first, shard.last,
                           {run.path(), run.prepared(shard.work), number, checkpoint});
  } catch (const InputError& error) {
    line.error = error.what();
    complain(line.error);
  }
  line.seconds = std::chrono::duration<double>(Time::now() - began).count();
  append(results, run.identity(), line);
  if (!line.error.empty()) return 2;
  std::error_code ignored;
  fs::remove(kept, ignored);
  return line.result.contains("failed") ? 1 : 0;
}

}  // namespace

std::string list_of(const std::vector<std::uint64_t>& shards) {
  std::string text;
  for (std::size_t i = 0; i < shards.size();) {
    std::size_t last = i;
    while (last + 1 < shards.size() && shards[last + 1] == shards[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", shards[i]);
    if (last > i) text += fmt::format("-{}", shards[last]);
    i = last + 1;
  }
  return text;
}

std::vector<std::uint64_t> shards_in(const std::string& list, std::uint64_t shards,
                                     const std::string& what) {
  const InputError wrong(
      fmt::format("{}: {} is no list of shards below {}", what, in_quotes(list), shards));
  std::vector<std::uint64_t> all;
  for (std::string part : parts_in(list, ',')) {
    const std::uint64_t first = take_number(part, wrong);
    std::uint64_t last = first;
    if (part.starts_with('-')) {
      part.erase(0, 1);
      last = take_number(part, wrong);
    }
    if (!part.empty() || last < first || last >= shards) throw wrong;
    for (std::uint64_t n = first; n <= last; ++n) all.push_back(n);
  }
  if (all.empty()) throw wrong;
  return all;
}

int run_shards(const RunFolder& run, const Kinds& kinds, const std::vector<std::uint64_t>& shards,
               const std::string& name) {
  const InterruptGuard interrupts;
  const fs::path results = run.path() / "results" / (name + ".jsonl");
  std::map<std::size_t, Works> tasks;
  int status = 0;
  for (const std::uint64_t number : shards) {
    InterruptGuard::check();
    const Known& known = run.works()[run.shards()[number].work];
    if (!tasks.contains(known.task)) {
      tasks.clear();  // the shards come in the order of the tasks
      tasks.emplace(known.task, run.works_of(known.task, kinds));
    }
    const Work& work = *tasks.at(known.task)[known.in_task];
    status = std::max(status, run_shard(run, work, number, results));
  }
  return status;
}

std::string host() {
  if (const char* node = std::getenv("SLURMD_NODENAME"); node != nullptr) return node;
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "unknown";
  return name.data();
}

}  // namespace cosim::regress

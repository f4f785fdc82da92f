#include "tb/proof/reach.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>

#include "model/core/input_error.h"
#include "tb/support/output_file.h"
#include "tb/support/parallel.h"
#include "tb/support/pattern.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"

namespace cosim::proof {
namespace {

constexpr int kNoProgram = 127;
constexpr int kConflicts = 100000;  // of a SAT solver in a second, about
constexpr std::size_t kBounded = 1;
constexpr std::size_t kClocks = 20000, kSteps = 20'000'000;  // of random stimuli

// The rows of inputs in a file of write_cex, cut behind the first clock on which bad is 1; none
// where it is not.
std::vector<std::vector<bool>> tried(const Aig& graph, Aig::Lit bad, const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  std::vector<std::vector<bool>> rows;
  static const Pattern given(R"(p([0-9]+)@([0-9]+)=([01]))");
  for (const Pattern::Parts& part : given.all(read_file(file))) {
    const std::size_t clock = std::stoul(part[2]), input = std::stoul(part[1]);
    if (clock >= rows.size()) rows.resize(clock + 1, std::vector<bool>(graph.inputs()));
    if (input < graph.inputs()) rows[clock][input] = part[3] == "1";
  }
  if (rows.empty()) rows.emplace_back();
  const auto seen = graph.run(rows, {bad});
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i].front()) continue;
    rows.resize(i + 1);
    return rows;
  }
  return {};
}

// Each engine words its verdict otherwise, and each version of abc; the status is one for all.
bool says_never(const std::string& text) {
  return text.find("Status = 1 ") != std::string::npos || text.starts_with("UNSATISFIABLE") ||
         text.find("\nUNSATISFIABLE") != std::string::npos;
}

bool says_yes(const std::string& text) { return text.find("Status = 0 ") != std::string::npos; }

struct Search {
  std::string name, commands;  // the seconds follow
};

}  // namespace

Reached reach(const Aig& graph, Aig::Lit bad, int seconds, unsigned jobs) {
  const auto ends = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  Reached reached;
  if (bad == 0) {
    reached.ever = Ever::never;
    reached.by = "the same gates";
    return reached;
  }
  const Scratch scratch;
  const std::string aiger = (scratch.path() / "asked.aig").string();
  OutputFile file(aiger);
  file.text(graph.aiger(bad));
  file.close();
  // Without registers it is a question of logic alone.
  const bool sequential = graph.latches() > 0;
  std::vector<Search> engines{{"dsat", "ifraig; dsat -C "}, {"iprove", "iprove -C "}};
  if (sequential) {
    engines = {{"scorr and pdr", "scorr; pdr -T "},
               {"bmc3", "bmc3 -T "},
               {"lcorr and dprove", "lcorr; dprove -T "}};
  }
  // What lies deep is found by chance sooner than by search, which then only looks for less.
  std::vector<std::vector<bool>> chance;
  if (sequential) {
    chance = graph.tried(bad, std::min(kClocks, kSteps / (graph.gates() + 1)));
  }
  for (int round = 0, limit = std::min(seconds, 1); limit > 0; ++round) {
    std::vector<Ended> ended(engines.size());
    std::atomic<bool> decided = false;
    const auto found = [&](std::size_t i) {
      return (scratch.path() / fmt::format("found{}.{}", round, i)).string();
    };
    in_parallel(engines.size(), jobs, [&](std::uint64_t i) {
      if (decided || (!chance.empty() && i != kBounded)) return true;
      const std::string work =
          engines[i].commands + std::to_string(sequential ? limit : kConflicts * limit);
      ended[i] = run_program(
          {"env", "-C", scratch.path().string(), "yosys-abc", "-s", "-q",
           fmt::format("read_aiger asked.aig; strash; {}; print_status; write_cex -n {}", work,
                       found(i))},
          limit + 2, &decided);
      // Only the bounded search takes the clocks in order: what it finds is the least.
      const bool finds_least = i == kBounded || !sequential;
      if (sequential ? says_never(ended[i].text) : says_yes(ended[i].text)) decided = true;
      if (finds_least && says_yes(ended[i].text)) decided = true;
      return true;
    });
    for (const Ended& one : ended) {
      if (one.status == kNoProgram) throw InputError("needs yosys-abc, which comes with yosys");
    }
    std::string by;
    for (std::size_t i = 0; i < engines.size(); ++i) {
      if (says_never(ended[i].text)) by += (by.empty() ? "" : "; ") + engines[i].name;
    }
    if (!by.empty()) {
      reached.ever = Ever::never;
      reached.by = by;
      return reached;
    }
    for (const std::size_t i : {1U, 0U, 2U}) {
      if (i >= engines.size()) continue;
      const auto rows = tried(graph, bad, found(i));
      if (!rows.empty()) return Reached{Ever::yes, engines[i].name, rows, i == 1 || !sequential, 0};
    }
    static const Pattern reaches(R"(No output failed in ([0-9]+) frames)");
    for (const auto& part : reaches.all(ended[1].text)) reached.clocks = std::stoi(part[1]);
    const std::chrono::duration<double> left = ends - std::chrono::steady_clock::now();
    const auto at_a_time = std::min<std::size_t>(jobs, engines.size());
    const double each =
        left.count() * static_cast<double>(at_a_time) / static_cast<double>(engines.size());
    limit = chance.empty() ? std::min(8 * limit, static_cast<int>(each)) : 0;
  }
  if (!chance.empty()) return Reached{Ever::yes, "random stimuli", chance, false, 0};
  return reached;
}

}  // namespace cosim::proof

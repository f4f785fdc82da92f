// A portfolio: searches for a proof and for a stimulus go side by side, and the first that is sure
// ends the others. A stimulus is sought in the order of clocks too (bounded model checking), so
// that it is the shortest where that comes to an end soon enough.
#include "tb/proof/reach.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

#include "model/core/input_error.h"
#include "tb/proof/chance.h"
#include "tb/util/output_file.h"
#include "tb/util/parallel.h"
#include "tb/util/pattern.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"

namespace cosim::proof {
namespace {

using Clock = std::chrono::steady_clock;
using Rows = std::vector<std::vector<bool>>;

constexpr std::size_t kClocks = 20000, kSteps = 20'000'000;  // of random stimuli at a time
constexpr const char* kChance = "random stimuli";
constexpr auto kTurn = std::chrono::seconds(1);

// The rows of inputs in a file of write_cex, cut behind the first clock on which bad is 1; none
// where it is not.
Rows tried(const nets::Graph& graph, nets::Bit bad, const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  Rows rows;
  static const Pattern given(R"(p([0-9]+)@([0-9]+)=([01]))");
  for (const Pattern::Parts& part : given.all(read_file(file))) {
    const std::size_t clock = std::stoul(part[2]), input = std::stoul(part[1]);
    if (clock >= rows.size()) rows.resize(clock + 1, std::vector<bool>(graph.inputs().size()));
    if (input < graph.inputs().size()) rows[clock][input] = part[3] == "1";
  }
  // A file of an engine that was stopped may be empty.
  if (rows.empty()) rows.emplace_back(graph.inputs().size());
  const auto seen = nets::traced(graph, rows, {bad});
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i].front()) continue;
    rows.resize(i + 1);
    return rows;
  }
  return {};
}

// Each engine words its verdict otherwise, and each version of abc; the status is one for all.
bool says_never(const std::string& text) { return text.find("Status = 1 ") != std::string::npos; }

bool says_unsatisfiable(const std::string& text) {
  return says_never(text) || text.starts_with("UNSATISFIABLE") ||
         text.find("\nUNSATISFIABLE") != std::string::npos;
}

struct Search {
  std::string name, commands;  // the seconds follow, where it is told them
  bool in_order = false;       // what it finds is the least
  bool told = true;
};

// Of registers and logic, and of logic alone.
const std::vector<Search> kSequential{{"scorr and dprove", "scorr; dprove -T "},
                                      {"bmc3", "bmc3 -T ", true},
                                      {"lcorr and pdr", "lcorr; pdr -T "}};
const std::vector<Search> kLogic{{"dsat", "ifraig; dsat", true, false},
                                 {"iprove", "iprove -C 1000000000", true, false}};

class Portfolio {
 public:
  Portfolio(const nets::Graph& graph, nets::Bit bad, Clock::time_point until, unsigned jobs)
      : graph_(graph),
        bad_(bad),
        until_(until),
        jobs_(jobs),
        searches_(!graph.latches().empty() ? kSequential : kLogic),
        is_logic_(graph.latches().empty()) {
    OutputFile file((scratch_.path() / "asked.aig").string());
    file.text(aiger(graph, {bad}));
    file.close();
  }

  Reached run() {
    // Most differences are met by chance at once; the search then only looks for less.
    if (!is_logic_) {
      chance_ = by_chance(graph_, bad_, 0, clocks_at_a_time());
      if (!chance_.empty()) return or_less();
    }
    // Those that cannot begin at once have turns, each longer than the last.
    const std::size_t all = searches_.size() + (is_logic_ ? 0 : 1);
    const bool turns = jobs_ < all;
    for (auto turn = kTurn; Clock::now() < until_; turn *= 4) {
      enough_ = false;
      running_ = searches_.size();
      said_.assign(searches_.size(), {});
      in_parallel(all, jobs_, [&](std::uint64_t i) {
        const auto ends = turns ? std::min(until_, Clock::now() + turn) : until_;
        if (i == searches_.size())
          try_chance(ends, turns);
        else
          ask(i, ends);
        return true;
      });
      Reached reached = result();
      if (reached.ever != Ever::open || !turns) return reached;
      clocks_ = std::max(clocks_, reached.clocks);
    }
    Reached open;
    open.clocks = clocks_;
    return open;
  }

 private:
  struct Said {
    bool never = false;
    Rows rows;  // on the last of which bad is 1
    int clocks = 0;
  };

  Said run_one(std::size_t i, Clock::time_point until, const std::string& more = {}) {
    const Search& search = searches_[i];
    const auto left = std::chrono::duration_cast<std::chrono::seconds>(until - Clock::now());
    const std::string found = (scratch_.path() / fmt::format("found{}", i)).string();
    const std::string seconds =
        search.told ? std::to_string(std::max<std::int64_t>(1, left.count())) : "";
    const Ended ended = run_until(
        {"env", "-C", scratch_.path().string(), "yosys-abc", "-s", "-q",
         fmt::format("read_aiger asked.aig; strash; {}{}{}; print_status; write_cex -n {}",
                     search.commands, seconds, more, found)},
        until, &enough_);
    if (ended.status == 127) throw InputError("needs yosys-abc, which comes with yosys");
    Said said;
    said.rows = tried(graph_, bad_, found);
    said.never = is_logic_ ? says_unsatisfiable(ended.text) : says_never(ended.text);
    static const Pattern reaches(R"(No output failed in ([0-9]+) frames)");
    for (const auto& part : reaches.all(ended.text)) said.clocks = std::stoi(part[1]);
    return said;
  }

  void ask(std::size_t i, Clock::time_point until) {
    try {
      if (!enough_) said_[i] = run_one(i, until);
    } catch (...) {
      enough_ = true;  // nobody waits for what one engine's error ends
      throw;
    }
    --running_;
    const bool found = !said_[i].rows.empty();
    if (!found && !said_[i].never) return;
    if (is_logic_ && !found && jobs_ == 1) return;  // the other comes next
    if (is_logic_ ? !found : found && !searches_[i].in_order) wait_for_others();
    enough_ = true;
  }

  // Whoever may find less, or agree, has a little time more.
  void wait_for_others() {
    const auto ends = Clock::now() + 2 * kTurn;
    while (!enough_ && running_ > 0 && Clock::now() < ends) {
      pause();
    }
  }

  static void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(10)); }

  std::size_t clocks_at_a_time() const {
    return std::min(kClocks, kSteps / (graph_.gates().size()));
  }

  // Long runs and short ones in turn, half of the time: the rest is for the others.
  void try_chance(Clock::time_point until, bool in_turns) {
    constexpr std::size_t more = 8;
    const std::size_t most = more * clocks_at_a_time();
    const auto stops = [&] {
      return enough_ || (!in_turns && running_ == 0) || Clock::now() >= until;
    };
    while (!stops() && chance_.empty()) {
      const auto began = Clock::now();
      const std::size_t clocks = seed_ % 2 == 0 ? most : most / (more * more) + 1;
      chance_ = by_chance(graph_, bad_, ++seed_, clocks, stops);
      const auto rests = Clock::now() + (Clock::now() - began);
      while (chance_.empty() && !in_turns && !stops() && Clock::now() < rests) pause();
    }
    if (chance_.empty()) return;
    wait_for_others();
    enough_ = true;
  }

  // The stimulus of chance, or a shorter one that is found soon.
  Reached or_less() {
    std::size_t bounded = 0;
    while (!searches_[bounded].in_order) ++bounded;
    const int before = static_cast<int>(chance_.size()) - 1;
    if (before == 0) return Reached{Ever::yes, kChance, chance_, true, 0};
    const Said less =
        run_one(bounded, std::min(until_, Clock::now() + 2 * kTurn), fmt::format(" -F {}", before));
    if (!less.rows.empty()) return Reached{Ever::yes, searches_[bounded].name, less.rows, true, 0};
    return Reached{Ever::yes, kChance, chance_, less.clocks >= before, 0};
  }

  // A stimulus has been tried, and goes before what is only said.
  Reached result() const {
    Reached reached;
    for (std::size_t i = 0; i < searches_.size(); ++i) {
      const Said& said = said_[i];
      reached.clocks = std::max(reached.clocks, said.clocks);
      if (said.rows.empty() || (reached.ever == Ever::yes && !searches_[i].in_order)) continue;
      reached = {Ever::yes, searches_[i].name, said.rows, searches_[i].in_order, 0};
    }
    if (reached.ever == Ever::yes) return reached;
    if (!chance_.empty()) return Reached{Ever::yes, kChance, chance_, false, 0};
    for (std::size_t i = 0; i < searches_.size(); ++i) {
      if (!said_[i].never) continue;
      reached.ever = Ever::never;
      ++reached.engines;
      reached.by += (reached.by.empty() ? "" : "; ") + searches_[i].name;
    }
    return reached;
  }

  const nets::Graph& graph_;
  nets::Bit bad_;
  Clock::time_point until_;
  unsigned jobs_;
  const std::vector<Search>& searches_;
  bool is_logic_;
  Scratch scratch_;
  std::atomic<bool> enough_ = false;
  std::atomic<std::size_t> running_ = 0;
  std::vector<Said> said_;
  Rows chance_;
  std::uint64_t seed_ = 0;
  int clocks_ = 0;
};

}  // namespace

Reached reach(const nets::Graph& graph, nets::Bit bad, Clock::time_point until, unsigned jobs) {
  if (bad == nets::no) return Reached{Ever::never, "the same gates", {}, false, 0};
  return Portfolio(graph, bad, until, jobs).run();
}

}  // namespace cosim::proof

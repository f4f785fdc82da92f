#include "tb/equiv/replay.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "tb/equiv/testbench.h"
#include "tb/support/output_file.h"
#include "tb/support/parallel.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"
#include "tb/support/words.h"

namespace cosim::equiv {
namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::vector<std::string>>;  // words of outputs, a line a clock

// One side as a program of Verilator.
class Program {
 public:
  Program(const Question& q, const Answer& a, bool is_gate)
      : q_(q), files_((is_gate ? q.gate : q.gold).files()), own_(scratch_.path().string()) {
    write_file(own_ + "/cosim_replay.v",
               testbench(q, a, is_gate, own_ + "/rows", own_ + "/wave.vcd", first_drawn(q, a)));
    write_file(own_ + "/rows", stimulus_rows(q, a, is_gate));
    std::vector<std::string> words = words_in(
        "verilator --binary --trace -Wno-fatal -Wno-lint -Wno-style --x-initial unique --x-assign "
        "unique --timescale 1ns/1ps --top-module cosim_replay +define+SYNTHESIS --Mdir");
    words.push_back(own_ + "/built");
    words.insert(words.begin(), {"env", "-C", files_.folder.string()});
    for (const std::string& define : files_.defines) words.push_back("+define+" + define);
    for (const fs::path& folder : files_.include_dirs) {
      words.push_back("+incdir+" + fs::absolute(folder).string());
    }
    for (const fs::path& one : files_.files) {
      words.push_back("+incdir+" + fs::absolute(one).parent_path().string());
      words.push_back(fs::absolute(one).string());
    }
    words.push_back(own_ + "/cosim_replay.v");
    for (const char* word : {"-MAKEFLAGS", "OPT_FAST= OPT_GLOBAL="}) words.emplace_back(word);
    // Verilator's own library is the same each time.
    if (is_installed("ccache")) words.insert(words.begin() + 3, "OBJCACHE=ccache");
    const Ended built = run_until(words, q.budget.ends());
    if (built.timed_out) throw OutOfTime();
    is_built_ = built.status == 0;
  }

  bool is_built() const { return is_built_; }

  // What it prints; nothing where it does not end well. A file of $readmemh is found from the
  // working directory, or beside the RTL.
  Lines run(const std::string& begins, bool draws = false) const {
    std::vector<fs::path> folders{files_.folder};
    for (const fs::path& file : files_.files) folders.push_back(fs::absolute(file).parent_path());
    Ended ended;
    for (const fs::path& folder : folders) {
      std::vector<std::string> words{"env",
                                     "-C",
                                     folder.string(),
                                     own_ + "/built/Vcosim_replay",
                                     "+verilator+rand+reset+" + begins,
                                     "+verilator+seed+1"};
      if (draws) words.emplace_back("+cosim_wave");
      ended = run_until(words, q_.budget.ends());
      if (ended.timed_out) throw OutOfTime();
      if (ended.text.find("$readmem file not found") == std::string::npos) break;
      ended.status = 1;
    }
    Lines lines;
    if (ended.status != 0) return lines;
    for (const std::string& line : lines_in(ended.text)) {
      const std::vector<std::string> words = words_in(line);
      if (words.empty() || words[0] != "cosim_replay") continue;  // what the RTL itself prints
      lines.emplace_back(words.begin() + 1, words.end());
    }
    return lines;
  }
  std::string drawn(const std::string& begins) const {
    run(begins, true);
    return read_file(own_ + "/wave.vcd");
  }

 private:
  const Question& q_;
  const Files& files_;
  const Scratch scratch_;
  std::string own_;
  bool is_built_ = false;
};

// Whether an output that is compared differs on the last clock, and all that is assumed held.
bool differs(const Question& q, const Answer& a, const Lines& gold, const Lines& gate) {
  const auto last = a.clocks.size(), then = last - static_cast<std::size_t>(q.latency);
  if (gold.size() < last || gate.size() < last) return false;
  const auto holds = [](const std::string& bit) { return bit == "1"; };
  for (auto t = static_cast<std::size_t>(q.reset_clocks); t < last; ++t) {
    const auto assumed = static_cast<std::ptrdiff_t>(q.assumed.size());
    if (!std::all_of(gold[t].end() - assumed, gold[t].end(), holds)) return false;
  }
  std::size_t at = 0;
  for (const auto& [port, text] : a.clocks.back().gold) {
    const std::string &old = gold[then - 1].at(at), &now = gate[last - 1].at(at);
    ++at;
    if (std::ranges::find(a.differing, port) == a.differing.end()) continue;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] != '-' && old[i] != now[i]) return true;
    }
  }
  return false;
}

// What has no initial value begins as 0, as 1 and by chance.
constexpr std::array beginnings{"0", "1", "2"};

Replay replay(const Question& q, const Answer& a) {
  std::optional<Program> programs[2];
  std::vector<Lines> lines[2];
  in_parallel(2, q.jobs, [&](std::uint64_t i) {
    programs[i].emplace(q, a, i == 1);
    if (!programs[i]->is_built()) return true;
    for (const char* begins : beginnings) lines[i].push_back(programs[i]->run(begins));
    return true;
  });
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& all = lines[i];
    if (!all.empty() && std::ranges::none_of(all, [](auto& l) { return l.empty(); })) continue;
    return {
        false,
        false,
        fmt::format("on the netlists: Verilator does not build the {} RTL", i == 0 ? "old" : "new"),
        {},
        {}};
  }
  for (std::size_t o = 0; o < beginnings.size(); ++o) {
    for (std::size_t n = 0; n < beginnings.size(); ++n) {
      if (!differs(q, a, lines[0][o], lines[1][n])) continue;
      Replay shown{true, false, "in Verilator", {lines[0][o], {}}, {lines[1][n], {}}};
      try {
        in_parallel(2, q.jobs, [&](std::uint64_t i) {
          (i == 0 ? shown.gold : shown.gate).vcd = programs[i]->drawn(beginnings[i == 0 ? o : n]);
          return true;
        });
      } catch (const OutOfTime&) {  // it is shown all the same
      }
      return shown;
    }
  }
  const auto is_any = [](const Register& r) { return r.any; };
  for (const Side* s : {&q.gold, &q.gate}) {
    if (s->unknowns > 0 || std::ranges::any_of(s->registers, is_any)) {
      return {false, false, "on the netlists: Verilator has other values for what is x", {}, {}};
    }
  }
  return {false, true, "in Verilator, which shows no difference", {}, {}};
}

}  // namespace

Replay replayed(const Question& q, const Answer& a) {
  const char* why = !q.verilator                 ? "on the netlists"
                    : !is_installed("verilator") ? "on the netlists: there is no Verilator"
                                                 : nullptr;
  if (why != nullptr) return {false, false, why, {}, {}};
  for (const Side* s : {&q.gold, &q.gate}) {
    if (!s->clocks_as_data.empty()) {
      return {false, false, "on the netlists: the clock is read as data", {}, {}};
    }
  }
  try {
    return replay(q, a);
  } catch (const OutOfTime&) {
    return {false, false, "on the netlists: no time was left for Verilator", {}, {}};
  }
}

}  // namespace cosim::equiv

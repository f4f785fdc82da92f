#include "tb/equiv/equiv.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "model/core/input_error.h"
#include "tb/equiv/clocks.h"
#include "tb/equiv/front_end.h"
#include "tb/equiv/product.h"
#include "tb/equiv/renamed.h"
#include "tb/equiv/replay.h"
#include "tb/equiv/trust.h"
#include "tb/proof/reach.h"
#include "tb/util/output_file.h"
#include "tb/util/parallel.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

// Whether the ports of both sides fit each other and the options.

using Widths = std::map<std::string, int>;

// Ports of one side that the other lacks, or has in another width.
void find_lacking(const Question& q, const Widths& gold, const Widths& gate, bool inputs,
                  std::vector<std::string>& lacking) {
  const auto is_free = [&](const std::string& port) {
    if (inputs && !q.steps && (q.gold.clocks.contains(port) || q.gate.clocks.contains(port))) {
      return true;
    }
    return inputs ? q.tied.contains(port) : std::ranges::find(q.ignored, port) != q.ignored.end();
  };
  std::set<std::string> met;
  for (const auto& [port, width] : gold) {
    const std::string other = gate_name(q, port);
    met.insert(other);
    if (is_free(port)) continue;
    const auto at = gate.find(other);
    if (at == gate.end()) {
      lacking.push_back(port + " only in the old");
    } else if (at->second != width) {
      lacking.push_back(fmt::format("{} has {} bits and {}", port, width, at->second));
    }
  }
  for (const auto& [port, width] : gate) {
    if (!met.contains(port) && !is_free(port)) lacking.push_back(port + " only in the new");
  }
}

// What the options name.
void require_named(const Question& q) {
  for (const auto& [pin, value] : q.tied) {
    const std::string other = gate_name(q, pin);
    const bool is_old = q.gold.inputs.contains(pin);
    if (!is_old && !q.gate.inputs.contains(other)) {
      throw InputError(fmt::format("--tie: {} is no input", in_quotes(pin)));
    }
    const int width = is_old ? q.gold.inputs.at(pin) : q.gate.inputs.at(other);
    if (value.size() > static_cast<std::size_t>(width)) {
      throw InputError(fmt::format("--tie: {} has {}, and the value needs {}", in_quotes(pin),
                                   count(static_cast<std::uint64_t>(width), "bit"), value.size()));
    }
    const bool is_clock = q.gold.clocks.contains(pin) || q.gate.clocks.contains(other);
    if (is_clock && (!q.steps || value != "0")) {
      throw InputError(fmt::format("--tie: {} is a clock", in_quotes(pin)));
    }
  }
  for (const std::string& pin : q.ignored) {
    if (!q.gold.outputs.contains(pin) && !q.gate.outputs.contains(pin)) {
      throw InputError(fmt::format("--ignore: {} is no output", in_quotes(pin)));
    }
  }
  for (const auto& [pin, other] : q.renamed) {
    if (!q.gold.declared.contains(pin)) {
      throw InputError(fmt::format("--map: the old RTL has no port {}", in_quotes(pin)));
    }
    if (!q.gate.declared.contains(other)) {
      throw InputError(fmt::format("--map: the new RTL has no port {}", in_quotes(other)));
    }
  }
}

// InputError where an option names a port that is not there, where the sides have other ports or
// widths than the options explain, or where their clocks have other edges.
void require_ports(const Question& q) {
  require_named(q);
  std::vector<std::string> lacking;
  find_lacking(q, q.gold.inputs, q.gate.inputs, true, lacking);
  find_lacking(q, q.gold.outputs, q.gate.outputs, false, lacking);
  if (!lacking.empty()) {
    throw InputError(fmt::format(
        "the ports differ: {}; write --tie INPUT=VALUE, --ignore OUTPUT or --map OLD=NEW",
        fmt::join(lacking, ", ")));
  }
  for (const auto& [clock, falls] : q.gold.clocks) {
    const auto other = q.steps ? q.gate.clocks.find(gate_name(q, clock)) : q.gate.clocks.begin();
    if (other == q.gate.clocks.end() || other->second == falls) continue;
    throw InputError(fmt::format("clock {}: the old RTL uses the {} edge, the new RTL the {} edge",
                                 clock, falls ? "falling" : "rising",
                                 falls ? "rising" : "falling"));
  }
}

// InputError for what has no meaning where there are several clocks.
void require_steps(const Question& q) {
  if (q.latency > 0) throw InputError("--latency: there are several clocks");
  for (const Side* side : {&q.gold, &q.gate}) {
    for (const std::string& clock : side->clocks_as_data) {
      throw InputError(clock + ": is read as data, and there are several clocks");
    }
  }
}

// The memories of both that can be one; none where that is not so of all. One without initial
// values begins as any, which is the same in both only where its name is.
Pairs memory_pairs(const Question& q) {
  const auto &olds = q.gold.memories, &news = q.gate.memories;
  if (olds.size() != news.size()) return {};
  Pairs pairs;
  std::vector<bool> taken(news.size());
  const auto take = [&](std::size_t i, const auto& fits) {
    for (std::size_t j = 0; j < news.size(); ++j) {
      if (taken[j] || olds[i].shape != news[j].shape || !fits(news[j])) continue;
      if (q.steps && olds[i].clock != gold_name(q, news[j].clock)) continue;
      taken[j] = true;
      pairs.emplace_back(i, j);
      return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < olds.size(); ++i) {
    const bool found = take(i, [&](const Memory& m) { return m.name == olds[i].name; }) ||
                       take(i, [&](const Memory& m) { return !m.any; });
    if (!found) return {};
  }
  return pairs;
}

void make_gates(Question& q, Memories how, Answer& answer) {
  in_parallel(2, q.jobs, [&](std::uint64_t i) {
    Side& side = i == 0 ? q.gold : q.gate;
    try {
      side.make_gates(how, q.steps, q.budget);
    } catch (const Refused&) {
      throw;
    } catch (const InputError&) {
      if (side.front_end() == FrontEnd::slang || !has_slang()) throw;
      side = Side(side.files(), side.what(), FrontEnd::slang, q.budget);
      side.make_gates(how, q.steps, q.budget);
    }
    return true;
  });
  name_alike(q.gold, q.gate);
  find_resets(q);
  answer.renamed = name_renamed(q);
}

// In this share of the time that is left, and no more than so many seconds. `called`: the file of
// q.keep that the question goes to.
proof::Reached reach(const Question& q, const Product& product, const std::string& called,
                     double share = 1, std::chrono::seconds most = std::chrono::hours(24)) {
  q.budget.check();
  if (!q.keep.empty()) {
    OutputFile file((q.keep / (called + ".aig")).string());
    file.text(aiger(product.graph, {product.bad}, product.names));
    file.close();
  }
  const auto now = Budget::Clock::now();
  const std::chrono::duration<double> left = share * (q.budget.ends() - now);
  const auto until = now + std::chrono::duration_cast<Budget::Clock::duration>(
                               std::min<std::chrono::duration<double>>(left, most));
  return proof::reach(product.graph, product.bad, until, q.jobs);
}

// Takes over that they are equal; where all of it rests on abc's word it is checked.
void take_equal(const Question& q, const Product& product, const proof::Reached& reached,
                Answer& answer) {
  answer.verdict = Verdict::equal;
  answer.by = reached.by;
  const bool by_two = product.graph.latches().empty() && reached.engines > 1;
  if (reached.engines == 0 || by_two) return;
  const Budget::Clock::duration least = q.check_least, most = q.check_most;
  const auto ends = Budget::Clock::now() + std::min(std::max(q.budget.spent(), least), most);
  answer.check = proof::invariant_of(product.graph, product.bad, std::min(ends, q.budget.ends()));
}

// Whether the registers of the same name, and what else there is of inputs, make both equal; of
// outputs that come later nothing is known so.
bool is_equal_by_names(const Question& q, const Pairs& memories, Answer& answer) {
  constexpr std::chrono::seconds soon(10);
  const Product cut = product_of(q, Registers::one, {}, memories);
  answer.matched = cut.matched;
  if (q.latency > 0) return false;
  const auto step = reach(q, cut, memories.empty() ? "by-names" : "memories-by-names", 1, soon);
  if (step.ever != proof::Ever::never) return false;
  take_equal(q, cut, step, answer);
  if (cut.matched > 0) answer.by.insert(0, "registers by name, ");
  return true;
}

// With the memories of both as one: equal, or different whatever is read and is x, or nothing is
// known.
bool is_decided_by_memories(const Question& q, const Pairs& memories, Answer& answer) {
  if (!is_equal_by_names(q, memories, answer)) {
    // The rest is for what comes after; most of what is equal is so here, or it differs soon.
    constexpr double share = 0.7;
    const Product product = product_of(q, Registers::two, {}, memories);
    const auto reached = reach(q, product, "memories-from-reset", share);
    if (reached.ever != proof::Ever::never) {
      const Product ternary = whatever_is_free(product_of(q, Registers::two, {{}, true}, memories));
      const auto differs = reach(q, ternary, "memories-differ", share);
      if (differs.ever != proof::Ever::yes) return false;
      answer.by = differs.by;
      show(q, ternary, differs, {}, answer);
      return true;
    }
    take_equal(q, product, reached, answer);
  }
  answer.by = "memories that get the same, " + answer.by;
  return true;
}

// Takes over what the search has come to: whether that is all, but for a difference to be looked
// at.
bool is_over(const Question& q, const Product& product, const proof::Reached& reached,
             Answer& answer) {
  answer.compared = std::max(0, reached.clocks - q.reset_clocks);
  if (reached.ever == proof::Ever::open) return true;
  answer.by = reached.by;
  if (reached.ever == proof::Ever::never) take_equal(q, product, reached, answer);
  return reached.ever == proof::Ever::never;
}

// The old RTL's x as any value. Some values are tried; a stimulus that tells the RTLs apart with
// these is one only if no others make the old RTL do what the new one does, and else these are
// tried as well (refinement by counterexamples).
void compare_with_any(const Question& q, std::vector<Filler> first, Answer& answer) {
  constexpr int rounds = 12;
  Unknown unknown{first_fillers(unknown_bits(q))};
  for (Filler& one : first) unknown.fillers.push_back(std::move(one));
  for (int round = 0; round < rounds; ++round) {
    const Product product = product_of(q, Registers::two, unknown, {});
    const proof::Reached reached = reach(q, product, "from-reset-with-x-tried");
    if (is_over(q, product, reached, answer)) return;
    const Certain certain = certain_of(q, product, reached);
    if (certain.any) {
      answer.least = reached.least && round == 0;
      return show(q, product, reached, certain.open, answer);
    }
    if (certain.others.empty()) break;
    constexpr std::size_t copies = 24;  // of the old RTL
    if (unknown.fillers.size() + certain.others.size() > copies) break;
    for (const Filler& other : certain.others) unknown.fillers.push_back(other);
  }
  answer.left = "what the old RTL leaves x may be more than was tried";
}

void compare_all(Question& q, Answer& answer) {
  make_gates(q, Memories::cut, answer);
  if (!are_trusted(q, answer)) return;
  if (q.latency == 0 && q.renamed.empty() && q.gold.form() == q.gate.form()) {
    answer.verdict = Verdict::equal;
    answer.by = "the same netlist";
    return;
  }
  if (q.steps) require_steps(q);
  const Pairs memories = memory_pairs(q);
  if (!memories.empty()) {
    make_gates(q, Memories::cut, answer);
    if (is_decided_by_memories(q, memories, answer)) return;
  }
  make_gates(q, Memories::registers, answer);
  // The registers that both have by name are equal nearly always: then one clock from any state
  // is all of the question.
  if (is_equal_by_names(q, {}, answer)) return;
  const Product product = product_of(q, Registers::two, {}, {});
  const proof::Reached reached = reach(q, product, "from-reset");
  if (is_over(q, product, reached, answer)) return;
  // Whatever it leaves x, if there is any; else other values have to be tried.
  Certain certain;
  const bool leaves_x = q.gold.unknowns > 0 || product.alone_any;
  if (leaves_x) certain = certain_of(q, product, reached);
  if (leaves_x && !certain.any) return compare_with_any(q, std::move(certain.others), answer);
  answer.least = reached.least;
  show(q, product, reached, certain.open, answer);
}

// No `equal` rests on what cannot be.
void require_met(Question& q, Answer& answer) {
  bool met = false;
  try {
    met = are_met(q);
  } catch (const OutOfTime&) {
  }
  if (met) return;
  answer.verdict = Verdict::undecided;
  answer.left = "whether any stimulus satisfies what is assumed";
}

}  // namespace

bool has_several_clocks(const Question& q) {
  std::set<std::string> all;
  for (const auto& [clock, falls] : q.gold.clocks) all.insert(clock);
  for (const auto& [clock, falls] : q.gate.clocks) all.insert(gold_name(q, clock));
  if (all.size() < 2 || q.gold.clocks.size() > 1 || q.gate.clocks.size() > 1) return all.size() > 1;
  // The one clock has another name where the other RTL has no such port.
  return q.gate.inputs.contains(gate_name(q, q.gold.clocks.begin()->first)) ||
         q.gold.inputs.contains(gold_name(q, q.gate.clocks.begin()->first));
}

Answer compare(Question& q) {
  require_ports(q);
  Answer answer;
  try {
    compare_all(q, answer);
  } catch (const OutOfTime&) {
    answer.left = "the time is over";
  }
  if (answer.verdict == Verdict::equal) require_met(q, answer);
  if (answer.verdict != Verdict::different) return answer;
  const Replay replay = replayed(q, answer);
  answer.replayed = replay.how;
  if (replay.refuted) {
    answer.verdict = Verdict::undecided;
    answer.left = fmt::format("the netlists differ on clock {}, but not the RTL {}{}{}",
                              answer.clocks.size() - 1, replay.how, replay.why.empty() ? "" : ": ",
                              replay.why);
    return answer;
  }
  if (replay.shown) take_over(q, replay, answer);
  answer.late = late_outputs(q, answer);
  return answer;
}

}  // namespace cosim::equiv

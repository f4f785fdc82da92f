#include "tb/equiv/equiv.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/equiv/clocks.h"
#include "tb/equiv/product.h"
#include "tb/equiv/referee.h"
#include "tb/proof/reach.h"
#include "tb/util/output_file.h"
#include "tb/util/pattern.h"
#include "tb/util/process.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw InputError(fmt::format("--assume: {}: {}", in_quotes(text), why));
}

// It is put into a module: nothing in it may end the expression, or begin something else.
void require_expression(const std::string& text) {
  static const Pattern plain(R"([\w\s$'()\[\]{}:?<>=!&|^~+*/%,.-]+)");
  const bool is_comment =
      text.find("//") != std::string::npos || text.find("/*") != std::string::npos;
  std::string open;
  bool is_balanced = true;
  for (const char c : text) {
    static const std::string begins = "([{", ends = ")]}";
    if (begins.find(c) != std::string::npos) open += ends[begins.find(c)];
    if (ends.find(c) == std::string::npos) continue;
    is_balanced = is_balanced && !open.empty() && open.back() == c;
    if (!open.empty()) open.pop_back();
  }
  if (plain.whole(text).empty() || is_comment || !is_balanced || !open.empty()) {
    refuse(text, "is no expression of Verilog");
  }
}

// The names in it; digits of numbers and system functions are none.
std::vector<std::string> names_in(const std::string& text) {
  static const Pattern word(R"('[sS]?[bBoOdDhH]\s*\w+|\$?[A-Za-z_][\w$]*(\.[\w$]+)*)");
  std::vector<std::string> names;
  for (const Pattern::Parts& part : word.all(text)) {
    const char first = part[0].front();
    if (first == '\'' || first == '$') continue;
    if (std::ranges::find(names, part[0]) == names.end()) names.push_back(part[0]);
  }
  return names;
}

Assumption made(const std::string& text, std::size_t number, const Side& gold,
                const Budget& budget) {
  require_expression(text);
  const std::vector<std::string> names = names_in(text);
  const std::string module = fmt::format("cosim_assume{}", number);
  std::string verilog = fmt::format("module {}(", module);
  bool of_outputs = false;
  for (const std::string& name : names) {
    if (gold.clocks.contains(name)) refuse(text, name + " is a clock");
    const bool is_output = gold.outputs.contains(name);
    if (!is_output && !gold.inputs.contains(name)) refuse(text, name + " is no port");
    of_outputs = of_outputs || is_output;
    verilog += fmt::format("input {} {}, ", gold.declared.at(name), name);
  }
  verilog +=
      fmt::format("output cosim_holds);\n  assign cosim_holds = (\n{}\n) ? 1'b1 : 1'b0;\n", text) +
      "endmodule\n";
  const Scratch scratch;
  const std::string file = (scratch.path() / "assume.v").string();
  write_file(file, verilog);
  try {
    Side logic({{file}, module, {}, {}, {}, "."}, "", FrontEnd::yosys, budget);
    logic.make_gates(Memories::registers, false, budget);
    if (logic.unknowns > 0)
      refuse(text,
             "is x for some values: it contains an x, a division by 0, or a bit that a port does "
             "not have");
    const Refereed is = refereed(logic, {false, {}, true, false, budget.ends()});
    if (!is.agrees) {
      refuse(text, (is.by.empty() ? "no simulator reads it: " : "is misread: ") + is.wrong);
    }
    return {text, logic, verilog, module, names, of_outputs};
  } catch (const InputError& error) {
    static const Pattern place(R"(cannot read it: (?:\S*assume\.v:\d+: )?(.*))");
    const auto why = place.all(error.what());
    if (why.empty()) throw;
    refuse(text, why[0][1]);
  }
}

// Of inputs alone: what is possible on one clock is so on all of them.
proof::Ever on_a_clock(const Question& q) {
  Graph graph;
  std::map<Name, Bit> inputs;
  Bit all = yes;
  for (const Assumption& one : q.assumed) {
    const auto input = [&](const Name& name) {
      if (const auto tied = tied_bit(q, name)) return nets::constant(*tied);
      const auto [at, is_new] = inputs.try_emplace(name, no);
      if (is_new) at->second = graph.input();
      return at->second;
    };
    all = graph.and_of(all, one.logic.make(graph, input, {}, {}).outputs.at({"cosim_holds", 0}));
  }
  if (all == yes) return proof::Ever::yes;
  return proof::reach(graph, all, q.budget.ends(), q.jobs).ever;
}

constexpr int kClocks = 20;

proof::Ever from_reset(const Question& q) {
  Product product = product_of(q, Registers::two, {}, {});
  Bit clock = product.graph.latch(true);
  product.graph.next(clock, no);
  for (int i = 1; i < q.reset_clocks + kClocks; ++i) {
    const Bit next = product.graph.latch(false);
    product.graph.next(next, clock);
    clock = next;
  }
  const Bit kept = product.graph.and_of(product.held, clock);
  return proof::reach(product.graph, kept, q.budget.ends(), q.jobs).ever;
}

}  // namespace

std::vector<Assumption> assumptions(const std::vector<std::string>& texts, const Side& gold,
                                    const Budget& budget) {
  std::vector<Assumption> all;
  for (const std::string& text : texts) all.push_back(made(text, all.size(), gold, budget));
  return all;
}

bool are_met(Question& q) {
  if (q.assumed.empty()) return true;
  const bool of_outputs = std::ranges::any_of(q.assumed, &Assumption::of_outputs);
  if (of_outputs) {
    for (Side* side : {&q.gold, &q.gate}) side->make_gates(Memories::registers, q.steps, q.budget);
    find_resets(q);
  }
  const proof::Ever ever = of_outputs ? from_reset(q) : on_a_clock(q);
  if (ever != proof::Ever::never) return ever == proof::Ever::yes;
  std::string list;
  for (const Assumption& one : q.assumed)
    list += (list.empty() ? "" : " and ") + in_quotes(one.text);
  throw InputError(
      fmt::format("--assume: no stimulus satisfies {}{}; anything would be equal", list,
                  of_outputs ? fmt::format(" for {} clocks after the reset", kClocks) : ""));
}

}  // namespace cosim::equiv

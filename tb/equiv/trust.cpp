#include "tb/equiv/trust.h"

#include <fmt/core.h>

#include "model/core/input_error.h"
#include "tb/equiv/clocks.h"
#include "tb/equiv/front_end.h"
#include "tb/equiv/referee.h"
#include "tb/equiv/sources.h"
#include "tb/util/parallel.h"
#include "tb/util/pattern.h"
#include "tb/util/read_file.h"

namespace cosim::equiv {
namespace {

// What a side is made of: texts and, where they name other files, the places from which these are
// found. VHDL counts as it was written.
std::string source_of(const Side& side) {
  static const Pattern names_a_file(R"(`include|\$readmem|\$fopen|[Tt][Ee][Xx][Tt][Ii][Oo])");
  const Files& files = side.files();
  std::string all;
  for (const auto& file : files.vhdl.empty() ? files.files : files.vhdl) {
    const std::string text = read_file(file.string());
    all += text + '\0';
    if (names_a_file.in(text)) all += std::filesystem::absolute(file).string() + '\0';
  }
  for (const auto& folder : files.include_dirs) all += folder.string() + '\0';
  for (const auto* words : {&files.parameters, &files.defines}) {
    for (const std::string& word : *words) all += word + '\0';
  }
  return all + files.top;
}

// Reads a side that was not read as its source says with the other front end.
void read_again(Question& q, Side& side, const Referee& how, Trusted& trusted) {
  if (side.front_end() == FrontEnd::slang || !has_slang()) return;
  try {
    Side again(side.files(), side.what(), FrontEnd::slang, q.budget);
    if (again.inputs != side.inputs || again.outputs != side.outputs ||
        again.clocks != side.clocks) {
      return;
    }
    again.make_gates(Memories::cut, q.steps, q.budget);
    const Refereed is = refereed(again, how);
    if (!is.agrees) return;
    trusted = {FrontEnd::slang, is};
    side = std::move(again);
  } catch (const InputError&) {  // it stays as it was read
  }
}

}  // namespace

bool are_trusted(Question& q, Answer& answer) {
  // What is misread is misread in both, if the same ports are meant.
  if (q.renamed.empty() && q.latency == 0 && source_of(q.gold) == source_of(q.gate)) return true;
  // Of the time that is left, for Verilator builds for 5 to 20 s: nearly all where the netlists are
  // the same, and nothing else is to be done.
  const bool is_all = q.latency == 0 && q.renamed.empty() && q.gold.form() == q.gate.form();
  const auto now = Budget::Clock::now();
  const auto until = now + (q.budget.ends() - now) * (is_all ? 95 : 70) / 100;
  in_parallel(2, q.jobs, [&](std::uint64_t i) {
    const bool is_gate = i == 1;
    Side& side = is_gate ? q.gate : q.gold;
    Trusted& trusted = is_gate ? answer.gate_read : answer.gold_read;
    Referee how{q.steps, {}, is_gate, true, until};
    for (const auto& [pin, level] : *q.resets) {
      const std::string own = is_gate ? gate_name(q, pin) : pin;
      if (side.inputs.contains(own) && side.inputs.at(own) == 1) how.resets[own] = level;
    }
    trusted = {side.front_end(), refereed(side, how)};
    if (!trusted.is.agrees) read_again(q, side, how, trusted);
    if (trusted.is.agrees && side.has_unique() && trusted.is.by == name_of(Simulator::verilator)) {
      trusted.is.agrees = false;
      trusted.is.wrong =
          "an incomplete unique case or if leaves an x, which Verilator does not show: write a "
          "default";
    }
    const std::string port = trusted.is.agrees && side.unknowns > 0
                                 ? place_of_two_valued_port(sources_of(side.files()))
                                 : "";
    if (!port.empty()) {
      trusted.is.agrees = false;
      trusted.is.wrong = fmt::format(
          "{}: a port of a type of two values, beside a value that is x: the port would be 0, and "
          "neither reader nor simulator makes it so; declare it logic",
          port);
    }
    return true;
  });
  for (const auto& [trusted, side] :
       {std::pair(&answer.gold_read, &q.gold), std::pair(&answer.gate_read, &q.gate)}) {
    if (trusted->is.agrees) continue;
    answer.left = trusted->is.by.empty()
                      ? fmt::format("no simulator runs {}: {}", side->what(), trusted->is.wrong)
                      : fmt::format("{} is misread: {}", side->what(), trusted->is.wrong);
    if (const std::string kept = side->kept_by_function(); !kept.empty()) {
      answer.left += "; perhaps " + kept;
    }
    answer.left += slang_hint();
    return false;
  }
  return true;
}

}  // namespace cosim::equiv

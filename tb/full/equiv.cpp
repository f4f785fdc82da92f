// cosim equiv: two versions of RTL, proved the same or told apart.
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>

#include "model/core/input_error.h"
#include "tb/cli/named_values.h"
#include "tb/cli/number.h"
#include "tb/cli/outputs.h"
#include "tb/cli/verdicts.h"
#include "tb/equiv/equiv.h"
#include "tb/equiv/result.h"
#include "tb/full/commands.h"
#include "tb/full/equiv_sides.h"
#include "tb/new/verilog_words.h"
#include "tb/sim/progress.h"
#include "tb/util/draft.h"
#include "tb/util/interrupt.h"
#include "tb/util/output_file.h"
#include "tb/util/parallel.h"
#include "tb/util/pattern.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

int number(const std::string& option, const std::string& text, unsigned low, unsigned high) {
  return static_cast<int>(whole(option, text, low, high));
}

// A whole number, decimal or as 0x..., in binary digits.
std::string binary(const std::string& option, const std::string& text) {
  static const Pattern hexadecimal("0[xX]([0-9a-fA-F]+)");
  std::string bits;
  if (const Pattern::Parts part = hexadecimal.whole(text); !part.empty()) {
    for (const char digit : part[1])
      bits += fmt::format("{:04b}", std::stoi(std::string{digit}, nullptr, 16));
  } else {
    bits = fmt::format("{:b}", whole(option, text, 0, std::numeric_limits<std::uint64_t>::max()));
  }
  return bits.substr(std::min(bits.find('1'), bits.size() - 1));
}

void name_resets(const EquivOptions& o, equiv::Question& q) {
  if (o.reset_clocks) q.reset_clocks = number("--reset-clocks", *o.reset_clocks, 0, 1000);
  for (const auto& [pin, value] : named_values("--reset", o.resets)) {
    std::optional<bool>& level = q.wanted_resets[pin];
    if (!value.empty()) level = number("--reset", value, 0, 1) == 1;
    if (!q.gold.inputs.contains(pin) || q.gold.inputs.at(pin) != 1) {
      throw InputError(fmt::format("--reset: {} is no input of one bit", in_quotes(pin)));
    }
    if (q.gold.clocks.contains(pin)) {
      throw InputError(fmt::format("--reset: {} is a clock", in_quotes(pin)));
    }
  }
}

// No two ports of the old RTL are one of the new.
void name_ports(const EquivOptions& o, equiv::Question& q) {
  for (const auto& [port, other] : named_values("--map", o.renamed, "OLD=NEW")) {
    q.renamed.emplace(port, other);
  }
  for (const auto& [old_name, new_name] : named_values("--same", o.same, "OLD=NEW")) {
    q.same.emplace(old_name, new_name);
  }
  std::map<std::string, std::string> old_of;
  for (const auto& [port, text] : q.gold.declared) {
    const auto at = q.renamed.find(port);
    const std::string& other = at == q.renamed.end() ? port : at->second;
    const auto [known, is_new] = old_of.emplace(other, port);
    if (is_new || !q.gate.declared.contains(other)) continue;
    throw InputError(fmt::format("--map: {} and {} of the old RTL are both mapped to {} of the new",
                                 in_quotes(known->second), in_quotes(port), in_quotes(other)));
  }
}

// The verdict holds even if the difference cannot be kept. The page of what is kept, or "".
std::string keep_difference(const EquivOptions& o, const std::string& top, const equiv::Question& q,
                            const equiv::Answer& a) {
  std::fflush(stdout);
  try {
    const equiv::Kept kept =
        equiv::keep(top, q, a, o.common.failures_folder(), o.common.window().after);
    fmt::print("kept in: {}\n", one_line(kept.folder.string()));
    return kept.page;
  } catch (const InputError& error) {
    complain(fmt::format("the difference is not kept: {}", error.what()));
  }
  return "";
}

// The exit status, and what it is called there.
int end_with(equiv::Verdict verdict, const std::string& top, const std::string& text,
             Verdicts& verdicts) {
  using enum ci::Verdict::End;
  if (verdict == equiv::Verdict::equal) verdicts.add({top, passed, "", text});
  if (verdict == equiv::Verdict::different) verdicts.add({top, failure, "different", text});
  if (verdict == equiv::Verdict::undecided) verdicts.add({top, error, "undecided", text});
  return verdict == equiv::Verdict::equal ? 0 : verdict == equiv::Verdict::different ? 1 : 3;
}

int conclude(const EquivOptions& o, const std::string& top, const equiv::Question& q,
             const equiv::Answer& a, Verdicts& verdicts) {
  const std::string assumed = equiv::assumed_text(q), verdict = equiv::verdict_text(top, q, a);
  fmt::print("{}\n{}", assumed, verdict);
  const bool differs = a.verdict == equiv::Verdict::different;
  const std::string page = differs ? keep_difference(o, top, q, a) : "";
  if (o.common.report) write_file(*o.common.report, equiv::result_json(top, q, a));
  if (o.common.html) {
    write_file(*o.common.html, page.empty() ? equiv::page_of(top, q, a) : page);
    fmt::print("page: {}\n", one_line(*o.common.html));
  }
  return end_with(a.verdict, top, verdict + assumed + '\n', verdicts);
}

// A text with the files of --rev as git calls them, REV:FILE.
std::string as_in_git(const EquivOptions& o, const std::string& text) {
  static const Pattern exported(R"(\S*/cosim\.\w+/\d+/tree/)");
  return o.rev ? exported.replaced(text, *o.rev + ":") : text;
}

int compare(const EquivOptions& o, Verdicts& verdicts) {
  const InterruptGuard interrupts;
  const Scratch scratch;
  const BothFiles files = files_of(o, scratch.path());
  const int seconds = o.seconds ? number("--seconds", *o.seconds, 1, 1000000) : 300;
  const unsigned jobs =
      o.jobs ? static_cast<unsigned>(number("--jobs", *o.jobs, 1, 1024)) : std::max(4U, cores());
  const equiv::Budget budget(seconds);
  const std::string top = top_of(o, files.gate);
  require_own_folder(equiv::folder_of(top, o.common.failures_folder()));
  const auto undecided = [&](const char* why) {
    const std::string text =
        fmt::format("{}: undecided: {} in {} s (--seconds)\n", top, why, seconds);
    fmt::print("{}", text);
    return end_with(equiv::Verdict::undecided, top, text, verdicts);
  };
  BothSides sides;
  try {
    sides = read_sides(o, files, top, scratch.path(), budget, jobs);
  } catch (const equiv::OutOfTime&) {
    return undecided("yosys does not read it");
  }
  equiv::Question q{*sides.gold, *sides.gate};
  q.latency = o.latency ? number("--latency", *o.latency, 0, 1000) : 0;
  q.budget = budget;
  if (o.seconds) {
    q.check_least = q.check_most;
    q.check_most = std::max(q.check_most, std::chrono::seconds(seconds));
  }
  q.jobs = jobs;
  if (o.keep) {
    make_folder(*o.keep);
    q.keep = *o.keep;
  }
  q.wave_before = o.common.window().before;
  for (const auto& [pin, value] : named_values("--tie", o.tied, "PIN=VALUE")) {
    q.tied[pin] = binary("--tie", value);
  }
  const std::set<std::string> ignored(o.ignored.begin(), o.ignored.end());
  q.ignored.assign(ignored.begin(), ignored.end());
  name_ports(o, q);
  q.steps = equiv::has_several_clocks(q);
  name_resets(o, q);
  q.verilator = !o.netlists;
  try {
    q.assumed = equiv::assumptions(o.assumed, q.gold, budget);
  } catch (const equiv::OutOfTime&) {
    return undecided("yosys does not read --assume");
  }
  equiv::Answer answer = [&] {
    StateLine line;
    line.show(fmt::format("{}: asked from reset, at most {} s", top, seconds));
    return equiv::compare(q);
  }();
  answer.left = as_in_git(o, answer.left);
  return conclude(o, top, q, answer, verdicts);
}

// The files, and what they `include or give to $readmemh, and so on, wherever in their own folders,
// in `folders` or in the working directory it may be found. What cannot be read is left out.
std::vector<std::string> files_read(const std::vector<std::string>& files,
                                    const std::vector<std::string>& folders) {
  namespace fs = std::filesystem;
  std::vector<std::string> all = files;
  std::set<std::string> met(files.begin(), files.end());
  const auto add = [&](const fs::path& file) {
    std::error_code error;
    if (fs::is_regular_file(file, error) && met.insert(file.string()).second) all.push_back(file);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    VerilogText words;
    try {
      words = verilog_words(read_file(all[i]));
    } catch (const InputError&) {
      continue;
    }
    words.headers.insert(words.headers.end(), words.data.begin(), words.data.end());
    for (const std::string& name : words.headers) {
      add(name);
      add(fs::path(all[i]).parent_path() / name);
      for (const std::string& folder : folders) add(fs::path(folder) / name);
    }
  }
  return all;
}

int run(const EquivOptions& o) {
  check_outputs(o.common, files_read(files_named(o), o.include_dirs));
  const std::string top = o.top.value_or(o.gate_top.value_or(""));
  return with_verdicts(equiv_command.name, top.empty() ? "?" : top, o.common,
                       [&](Verdicts& verdicts) {
                         try {
                           return compare(o, verdicts);
                         } catch (const InputError& error) {
                           throw InputError(as_in_git(o, error.what()));
                         }
                       });
}

}  // namespace

void add_equiv(const Command& program) {
  auto o = std::make_shared<EquivOptions>();
  const Command command = program.sub(equiv_command.name, equiv_command.help);
  command.arguments("FILE", o->files,
                    "The old file and the new one; with --rev the files of the new RTL");
  command.texts("--gold", o->gold, "FILE",
                "The files of the old RTL; FILE.f is a list, as with -F");
  command.texts("--gate", o->gate, "FILE", "The files of the new RTL, or FILE.f");
  command.text("--rev", o->rev, "REV",
               "The old RTL: the same files as git has them in revision REV");
  command.each("-f", o->lists, "LIST",
               "With --rev: a list of files, +incdir+DIR, +define+NAME=VALUE, -y DIR, -v\n"
               "FILE, -f LIST; the old RTL has the list of that revision");
  command.each("-F", o->own_lists, "LIST", "The same, whose paths begin at the folder of the list");
  command.text("--top", o->top, "NAME",
               "The module that is compared; default: the one that no other has an\n"
               "instance of");
  command.text("--gold-top", o->gold_top, "NAME", "Its name in the old RTL");
  command.text("--gate-top", o->gate_top, "NAME", "Its name in the new RTL");
  command.texts("--cells", o->cells, "FILE",
                "Cells that both may use, of a netlist: Verilog, or Liberty (*.lib)");
  command.each("--blackbox", o->blackboxes, "NAME",
               "A module that no file has: what goes to its pins is compared");
  command.each("--param", o->parameters, "NAME=VALUE", "A parameter of the module, in both");
  command.each("--gold-param", o->gold_parameters, "NAME=VALUE",
               "One of the old RTL alone: a netlist has none");
  command.each("--gate-param", o->gate_parameters, "NAME=VALUE", "One of the new RTL alone");
  command.each("--include", o->include_dirs, "DIR", "A folder of headers");
  command.each("--define", o->defines, "NAME[=VALUE]", "A definition, in both");
  command.each("--reset", o->resets, "PIN[=0|1]", "A reset, and the level that resets");
  command.text("--reset-clocks", o->reset_clocks, "N",
               "Clocks for which the reset is given; default 3");
  command.each("--tie", o->tied, "PIN=VALUE", "An input that has that value");
  command.each("--ignore", o->ignored, "PIN", "An output that is not compared");
  command.each("--map", o->renamed, "OLD=NEW", "A port that has another name in the new RTL");
  command.each("--same", o->same, "OLD=NEW",
               "A register that has another name in the new RTL; most are found");
  command.each("--assume", o->assumed, "EXPRESSION",
               "Verilog over the old RTL's ports, true on each clock after reset");
  command.text("--latency", o->latency, "N", "The new outputs come N clocks later");
  command.flag("--netlists", o->netlists,
               "A difference is not replayed in Verilator, where Icarus Verilog cannot");
  command.text("--keep", o->keep, "DIR",
               "Keep what the engines are asked in DIR, as AIGER with the names of the RTL");
  command.text("--seconds", o->seconds, "N", "For all of it, reading included; default 300");
  command.text("--jobs", o->jobs, "J",
               "Engines at a time; default 4, or one a core where there are more");
  add_report(command, o->common);
  add_junit(command, o->common);
  add_html(command, o->common, "the wave of a difference");
  add_failures(command, o->common);
  command.footer(
      fmt::format("Needs yosys and Icarus Verilog, for most SystemVerilog slang too.\n"
                  "Exit status: 0 equal, 1 different, 2 bad input, 3 undecided.\n"
                  "Example: {} equiv old/uart.v uart.v",
                  program_name()));
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli

// cosim equiv: two versions of RTL, proved the same or told apart.
#include "tb/equiv/equiv.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include "model/core/input_error.h"
#include "tb/equiv/front_end.h"
#include "tb/equiv/result.h"
#include "tb/full_cli/commands.h"
#include "tb/new/found_shape.h"
#include "tb/program/common.h"
#include "tb/program/number.h"
#include "tb/program/outputs.h"
#include "tb/support/interrupt.h"
#include "tb/support/output_file.h"
#include "tb/support/parallel.h"
#include "tb/support/pattern.h"
#include "tb/support/process.h"
#include "tb/support/words.h"
#include "tb/sweep/progress.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

struct EquivOptions {
  Words gold, gate, files, cells, blackboxes, parameters, gold_parameters, gate_parameters,
      include_dirs, defines, resets, tied, ignored, renamed, assumed;
  Text rev, top, gold_top, gate_top, seconds, jobs, reset_clocks, latency;
  bool netlists = false;
  Common common;
};

std::pair<std::string, std::string> halves(const std::string& option, const std::string& text,
                                           const char* form) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos || at == 0 || at + 1 == text.size()) {
    throw InputError(fmt::format("{}: {} is not {}", option, in_quotes(text), form));
  }
  return {text.substr(0, at), text.substr(at + 1)};
}

int number(const std::string& option, const std::string& text, unsigned low, unsigned high) {
  return static_cast<int>(whole(option, text, low, high));
}

// What a revision has.
struct Revision {
  Words files;      ///< those that it lacks are left out
  fs::path folder;  ///< its version of the working directory
};

// The files as they were in a revision, in `folder`.
Revision revision(const std::string& rev, const Words& files, const fs::path& folder) {
  const auto git = [](Words words) {
    words.insert(words.begin(), "git");
    Ended ended = cosim::run_program(words);
    if (ended.status == 127) throw InputError("--rev: needs git");
    while (ended.text.ends_with('\n')) ended.text.pop_back();
    return ended;
  };
  const std::string beside = fs::absolute(files.front()).parent_path().string();
  const Ended root = git({"-C", beside, "rev-parse", "--show-toplevel"});
  if (root.status != 0) throw InputError(fmt::format("--rev: {} is in no git", files.front()));
  const std::string tar = (folder / "rev.tar").string();
  const bool named = !rev.empty() && rev.front() != '-';
  if (!named || git({"-C", root.text, "archive", "-o", tar, rev}).status != 0) {
    throw InputError(fmt::format("--rev: {} is no revision", in_quotes(rev)));
  }
  if (cosim::run_program({"tar", "-xf", tar, "-C", folder.string()}).status != 0) {
    throw InputError("--rev: needs tar");
  }
  Words old;
  for (const std::string& file : files) {
    const fs::path path = folder / fs::canonical(file).lexically_relative(fs::canonical(root.text));
    if (fs::exists(path)) old.push_back(path.string());
  }
  if (old.empty()) throw InputError(fmt::format("--rev: {} has none of the files", in_quotes(rev)));
  const fs::path here = folder / fs::current_path().lexically_relative(fs::canonical(root.text));
  return {old, fs::is_directory(here) ? here : folder};
}

equiv::Side side(const EquivOptions& o, const Words& files, const Text& own_top,
                 const Words& own_parameters, const char* what, const fs::path& folder,
                 const fs::path& made, const equiv::Budget& budget) {
  equiv::Files all;
  all.top = own_top ? *own_top : needed("--top", o.top);
  all.parameters = o.parameters;
  all.parameters.insert(all.parameters.end(), own_parameters.begin(), own_parameters.end());
  all.include_dirs.assign(o.include_dirs.begin(), o.include_dirs.end());
  all.defines = o.defines;
  all.folder = folder;
  Words verilog = files;
  verilog.insert(verilog.end(), o.cells.begin(), o.cells.end());
  const std::string wrong = as_plain_verilog(verilog, all.top, all.parameters, o.blackboxes, ".",
                                             made.parent_path(), made);
  if (!wrong.empty()) throw InputError("equiv: " + wrong);
  all.files.assign(verilog.begin(), verilog.end());
  try {
    return {all, what, equiv::FrontEnd::yosys, budget};
  } catch (const equiv::Refused&) {
    throw;
  } catch (const InputError& error) {
    if (!equiv::has_slang()) throw;
    try {
      return {all, what, equiv::FrontEnd::slang, budget};
    } catch (const InputError&) {
      throw InputError(error.what());
    }
  }
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
  for (const std::string& text : o.resets) {
    const std::string pin = text.substr(0, text.find('='));
    std::optional<bool>& level = q.wanted_resets[pin];
    if (pin != text) level = number("--reset", text.substr(pin.size() + 1), 0, 1) == 1;
    if (!q.gold.inputs.contains(pin) || q.gold.inputs.at(pin) != 1) {
      throw InputError(fmt::format("--reset: {} is no input of one bit", in_quotes(pin)));
    }
    if (q.gold.clocks.contains(pin)) {
      throw InputError(fmt::format("--reset: {} is a clock", in_quotes(pin)));
    }
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

int conclude(const EquivOptions& o, const std::string& top, const equiv::Question& q,
             const equiv::Answer& a) {
  fmt::print("{}\n{}", equiv::assumed_text(q), equiv::verdict_text(top, q, a));
  const bool differs = a.verdict == equiv::Verdict::different;
  std::string page = differs ? keep_difference(o, top, q, a) : "";
  if (o.common.report) write_file(*o.common.report, equiv::result_json(top, q, a));
  if (o.common.html) {
    write_file(*o.common.html, page.empty() ? equiv::page_of(top, q, a) : page);
    fmt::print("page: {}\n", one_line(*o.common.html));
  }
  return differs ? 1 : a.verdict == equiv::Verdict::equal ? 0 : 3;
}

int run(const EquivOptions& o) {
  const InterruptGuard interrupts;
  const Scratch scratch;
  Words gold = o.gold, gate = o.gate;
  fs::path gold_folder = ".";
  if (o.rev) {
    if (!gold.empty() || !gate.empty())
      throw InputError("--rev: does not go with --gold or --gate");
    if (o.files.empty()) throw InputError("FILE: is needed");
    gate = o.files;
    for (const std::string& file : gate) {
      if (!fs::exists(file)) throw InputError(file + ": No such file or directory");
    }
    Revision old = revision(*o.rev, gate, scratch.path());
    gold = std::move(old.files);
    gold_folder = std::move(old.folder);
  } else if (!o.files.empty()) {
    throw InputError(fmt::format("equiv: takes no {} without --rev", in_quotes(o.files.front())));
  }
  if (gold.empty()) throw InputError("--gold: is needed, or --rev");
  if (gate.empty()) throw InputError("--gate: is needed");
  const int seconds = o.seconds ? number("--seconds", *o.seconds, 1, 1000000) : 300;
  const unsigned jobs =
      o.jobs ? static_cast<unsigned>(number("--jobs", *o.jobs, 1, 1024)) : std::max(4U, cores());
  check_outputs(o.common);
  const equiv::Budget budget(seconds);
  const std::string top = o.top ? *o.top : *o.gate_top;
  const fs::path reader = write_reader(scratch);
  std::optional<equiv::Side> old, now;
  try {
    in_parallel(2, jobs, [&](std::uint64_t i) {
      if (i == 0)
        old = side(o, gold, o.gold_top, o.gold_parameters, "the old RTL", gold_folder,
                   reader / "was.v", budget);
      if (i == 1)
        now = side(o, gate, o.gate_top, o.gate_parameters, "the new RTL", ".", reader / "is.v",
                   budget);
      return true;
    });
  } catch (const equiv::OutOfTime&) {
    fmt::print("{}: undecided: yosys does not read it in {} s (--seconds)\n", top, seconds);
    return 3;
  }
  equiv::Question q{*old, *now};
  q.latency = o.latency ? number("--latency", *o.latency, 0, 1000) : 0;
  q.budget = budget;
  if (o.seconds) {
    q.check_least = q.check_most;
    q.check_most = std::max(q.check_most, std::chrono::seconds(seconds));
  }
  q.jobs = jobs;
  q.wave_before = o.common.window().before;
  for (const std::string& text : o.tied) {
    const auto [pin, value] = halves("--tie", text, "PIN=VALUE");
    q.tied[pin] = binary("--tie", value);
  }
  q.ignored = o.ignored;
  for (const std::string& text : o.renamed) q.renamed.insert(halves("--map", text, "OLD=NEW"));
  q.steps = equiv::has_several_clocks(q);
  name_resets(o, q);
  q.verilator = !o.netlists;
  try {
    q.assumed = equiv::assumptions(o.assumed, q.gold, budget);
  } catch (const equiv::OutOfTime&) {
    fmt::print("{}: undecided: yosys does not read --assume in {} s (--seconds)\n", top, seconds);
    return 3;
  }
  const equiv::Answer answer = [&] {
    StateLine line;
    line.show(fmt::format("{}: asked from reset, at most {} s", top, seconds));
    return equiv::compare(q);
  }();
  return conclude(o, top, q, answer);
}

}  // namespace

void add_equiv(const Command& program) {
  auto o = std::make_shared<EquivOptions>();
  const Command command = program.sub(equiv_command.name, equiv_command.help);
  command.arguments("FILE", o->files, "With --rev: the files of the new RTL");
  command.texts("--gold", o->gold, "FILE", "The files of the old RTL");
  command.texts("--gate", o->gate, "FILE", "The files of the new RTL");
  command.text("--rev", o->rev, "REV",
               "The old RTL: the same files as git has them in revision REV");
  command.text("--top", o->top, "NAME", "The module that is compared");
  command.text("--gold-top", o->gold_top, "NAME", "What it is called in the old RTL");
  command.text("--gate-top", o->gate_top, "NAME", "What it is called in the new RTL");
  command.texts("--cells", o->cells, "FILE", "Cells that both may use, of a netlist");
  command.each("--blackbox", o->blackboxes, "NAME",
               "A module that no file has: what goes to its pins is compared");
  command.each("--param", o->parameters, "NAME=VALUE", "A parameter of the module, in both");
  command.each("--gold-param", o->gold_parameters, "NAME=VALUE",
               "One of the old RTL alone: a netlist has none");
  command.each("--gate-param", o->gate_parameters, "NAME=VALUE", "One of the new RTL alone");
  command.each("--include", o->include_dirs, "DIR", "Where `include finds its files");
  command.each("--define", o->defines, "NAME[=VALUE]", "A definition, in both");
  command.each("--reset", o->resets, "PIN[=0|1]", "A reset, and the level that resets");
  command.text("--reset-clocks", o->reset_clocks, "N",
               "Clocks for which the reset is given; default 3");
  command.each("--tie", o->tied, "PIN=VALUE", "An input that has that value");
  command.each("--ignore", o->ignored, "PIN", "An output that is not compared");
  command.each("--map", o->renamed, "OLD=NEW", "A port that has another name in the new RTL");
  command.each("--assume", o->assumed, "EXPRESSION",
               "Verilog over the old RTL's ports, true on every clock after the reset");
  command.text("--latency", o->latency, "N", "The new outputs come N clocks later");
  command.flag("--netlists", o->netlists,
               "A difference is replayed on the netlists alone, not in Verilator: quicker");
  command.text("--seconds", o->seconds, "N", "For all of it, reading included; default 300");
  command.text("--jobs", o->jobs, "J",
               "Engines at a time; default 4, or one a core where there are more");
  add_report(command, o->common);
  add_html(command, o->common, "the wave of a difference");
  add_failures(command, o->common);
  command.footer(
      fmt::format("Needs yosys. Exit status: 0 equal, 1 different, 2 bad input, 3 undecided.\n"
                  "Example: {} equiv --gold old/uart.v --gate uart.v --top uart",
                  program_name()));
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli

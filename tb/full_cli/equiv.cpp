// cosim equiv: two versions of RTL, proved the same or told apart.
#include "tb/equiv/equiv.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "model/core/input_error.h"
#include "tb/full_cli/commands.h"
#include "tb/new/found_shape.h"
#include "tb/program/common.h"
#include "tb/program/number.h"
#include "tb/support/draft.h"
#include "tb/support/interrupt.h"
#include "tb/support/json.h"
#include "tb/support/output_file.h"
#include "tb/support/parallel.h"
#include "tb/support/process.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

struct EquivOptions {
  Words gold, gate, files, cells, parameters, include_dirs, defines, tied, ignored, renamed;
  Text rev, top, gold_top, gate_top, seconds, jobs, reset, reset_clocks, latency, report;
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
  if (old.empty()) {
    throw InputError(fmt::format("--rev: {} has none of the files", in_quotes(rev)));
  }
  const fs::path here = folder / fs::current_path().lexically_relative(fs::canonical(root.text));
  return {old, fs::is_directory(here) ? here : folder};
}

equiv::Side side(const EquivOptions& o, const Words& files, const Text& own_top, const char* what,
                 const fs::path& folder, const fs::path& made, const equiv::Budget& budget) {
  equiv::Files all;
  all.top = own_top ? *own_top : needed("--top", o.top);
  // What has the cells for its library is a netlist, which holds its parameters.
  all.parameters = o.parameters;
  all.include_dirs.assign(o.include_dirs.begin(), o.include_dirs.end());
  all.defines = o.defines;
  all.folder = folder;
  Words verilog = files;
  verilog.insert(verilog.end(), o.cells.begin(), o.cells.end());
  const std::string wrong =
      as_plain_verilog(verilog, all.top, all.parameters, {}, ".", made.parent_path(), made);
  if (!wrong.empty()) throw InputError("equiv: " + wrong);
  all.files.assign(verilog.begin(), verilog.end());
  return {all, what, budget};
}

void find_reset(const EquivOptions& o, equiv::Question& q) {
  static const std::set<std::string> high{"rst",   "reset", "clear",    "clr",
                                          "rst_i", "i_rst", "wb_rst_i", "i_reset"};
  static const std::set<std::string> low{"rst_n", "reset_n", "rstn",   "resetn",
                                         "nrst",  "aresetn", "rst_ni", "i_rst_n"};
  q.reset_clocks = o.reset_clocks ? number("--reset-clocks", *o.reset_clocks, 0, 1000) : 3;
  if (o.reset) {
    const std::size_t at = o.reset->find('=');
    q.reset = o.reset->substr(0, at);
    q.reset_active = at == std::string::npos
                         ? !low.contains(q.reset)
                         : number("--reset", o.reset->substr(at + 1), 0, 1) == 1;
    if (!q.gold.inputs.contains(q.reset) || q.gold.inputs.at(q.reset) != 1) {
      throw InputError(fmt::format("--reset: {} is no input of one bit", in_quotes(q.reset)));
    }
  } else {
    for (const auto& [port, width] : q.gold.inputs) {
      std::string name = port;
      std::transform(name.begin(), name.end(), name.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      if (width != 1 || !(high.contains(name) || low.contains(name))) continue;
      q.reset = port;
      q.reset_active = high.contains(name);
      break;
    }
  }
  if (q.reset.empty()) q.reset_clocks = 0;
}

std::string assumed(const equiv::Question& q) {
  std::string text =
      q.reset.empty() ? "no reset: from the initial values"
                      : fmt::format("from reset: {} is {} for {}", q.reset, q.reset_active ? 1 : 0,
                                    count(static_cast<std::uint64_t>(q.reset_clocks), "clock"));
  std::set<std::string> any;
  for (const equiv::Side* s : {&q.gold, &q.gate}) {
    for (const equiv::Register& r : s->registers) {
      if (r.any) any.insert(r.name.first);
    }
  }
  if (!any.empty()) {
    text += fmt::format("; without an initial value, so any: {}", count(any.size(), "register"));
  }
  for (const auto& [pin, value] : q.tied) text += fmt::format("; {} is {}", pin, value);
  for (const std::string& pin : q.ignored) text += fmt::format("; {} is not compared", pin);
  if (q.latency > 0) {
    text += fmt::format("; the new outputs come {} later",
                        count(static_cast<std::uint64_t>(q.latency), "clock"));
  }
  return text;
}

Json json_of_answer(const std::string& top, const equiv::Question& q, const equiv::Answer& a) {
  const char* verdict = a.verdict == equiv::Verdict::equal       ? "equal"
                        : a.verdict == equiv::Verdict::different ? "different"
                                                                 : "undecided";
  Json clocks = Json::array();
  for (const equiv::Row& row : a.clocks) {
    clocks.push_back({{"inputs", row.inputs}, {"old", row.gold}, {"new", row.gate}});
  }
  return {{"top", top},
          {"verdict", verdict},
          {"by", a.by},
          {"replayed", a.replayed},
          {"assumed", assumed(q)},
          {"registers_by_name", a.matched},
          {"stimulus", clocks},
          {"least", a.least},
          {"differing", a.differing},
          {"left", a.left},
          {"equal_clocks", a.compared}};
}

int conclude(const EquivOptions& o, const std::string& top, const equiv::Question& q,
             const equiv::Answer& a, std::optional<OutputFile>& report) {
  const Json json = json_of_answer(top, q, a);
  fmt::print("{}\n", assumed(q));
  int status = 0;
  if (a.verdict == equiv::Verdict::equal) {
    fmt::print("{}: equal for ever, by {}\n", top, a.by);
  } else if (a.verdict == equiv::Verdict::undecided) {
    const std::string first =
        "equal for the first " + count(static_cast<std::uint64_t>(a.compared), "clock");
    fmt::print("{}: undecided: {}{}\n", top, a.compared > 0 || a.left.empty() ? first + "; " : "",
               a.left.empty() ? "more is not known" : a.left);
    status = 3;
  } else {
    const equiv::Row& last = a.clocks.back();
    std::string list;
    for (const std::string& port : a.differing) {
      list += fmt::format("{} {} is {}, was {}", list.empty() ? "" : ",", port, last.gate.at(port),
                          last.gold.at(port));
    }
    fmt::print("{}: different on clock {}{}:{}; replayed {}\n", top, a.clocks.size(),
               a.least ? ", the first that can be" : "", list, a.replayed);
    Draft folder(o.common.failures_folder(), top + "-equiv");
    folder.write("report.json", json_text(json, 2) + "\n");
    std::string csv = "clock";
    for (const auto& [port, text] : last.inputs) csv += "," + port;
    for (const auto& [port, text] : last.gold) csv += fmt::format(",old {0},new {0}", port);
    for (std::size_t i = 0; i < a.clocks.size(); ++i) {
      csv += fmt::format("\n{}", i + 1);
      for (const auto& [port, text] : a.clocks[i].inputs) csv += "," + text;
      for (const auto& [port, text] : a.clocks[i].gold) {
        csv += fmt::format(",{},{}", text, a.clocks[i].gate.at(port));
      }
    }
    folder.write("stimulus.csv", csv + "\n");
    folder.finish();
    fmt::print("kept in {}\n", folder.target().string());
    status = 1;
  }
  if (report) {
    report->text(json_text(json, 2) + "\n");
    report->close();
  }
  return status;
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
  // A report that cannot be written is no answer to wait for.
  std::optional<OutputFile> report;
  if (o.report) report.emplace(*o.report);
  const equiv::Budget budget(seconds);
  const std::string top = o.top ? *o.top : *o.gate_top;
  const fs::path reader = write_reader(scratch);
  std::optional<equiv::Side> old, now;
  try {
    in_parallel(2, jobs, [&](std::uint64_t i) {
      if (i == 0)
        old = side(o, gold, o.gold_top, "the old RTL", gold_folder, reader / "was.v", budget);
      if (i == 1) now = side(o, gate, o.gate_top, "the new RTL", ".", reader / "is.v", budget);
      return true;
    });
  } catch (const equiv::OutOfTime&) {
    fmt::print("{}: undecided: yosys does not read it in {} s (--seconds)\n", top, seconds);
    return 3;
  }
  equiv::Question q{*old,   *now, {},
                    true,   3,    {},
                    {},     {},   o.latency ? number("--latency", *o.latency, 0, 1000) : 0,
                    budget, jobs};
  for (const std::string& text : o.tied) {
    const auto [pin, value] = halves("--tie", text, "PIN=VALUE");
    q.tied[pin] = number("--tie", value, 0, 999999999);
  }
  q.ignored = o.ignored;
  for (const std::string& text : o.renamed) q.renamed.insert(halves("--map", text, "OLD=NEW"));
  find_reset(o, q);
  q.verilator = !o.netlists;
  const equiv::Answer answer = equiv::compare(q);
  return conclude(o, top, q, answer, report);
}

}  // namespace

void add_equiv(const Command& program) {
  auto o = std::make_shared<EquivOptions>();
  const Command command = program.sub(equiv_command.name, equiv_command.help);
  command.arguments("FILE...", o->files, "With --rev: the files of the new RTL");
  command.texts("--gold", o->gold, "FILE...", "The files of the old RTL");
  command.texts("--gate", o->gate, "FILE...", "The files of the new RTL");
  command.text("--rev", o->rev, "REV", "The old RTL is what git has of the files in that revision");
  command.text("--top", o->top, "NAME", "The module that is compared");
  command.text("--gold-top", o->gold_top, "NAME", "What it is called in the old RTL");
  command.text("--gate-top", o->gate_top, "NAME", "What it is called in the new RTL");
  command.texts("--cells", o->cells, "FILE...", "Cells that both may use, of a netlist");
  command.texts("--param", o->parameters, "NAME=VALUE", "A parameter of the module, in both");
  command.texts("--include", o->include_dirs, "DIR", "Where `include finds its files");
  command.texts("--define", o->defines, "NAME[=VALUE]", "A definition, in both");
  command.text("--reset", o->reset, "PIN[=0|1]", "The reset, and the level that resets");
  command.text("--reset-clocks", o->reset_clocks, "N", "For how many clocks it resets; default 3");
  command.texts("--tie", o->tied, "PIN=VALUE", "An input that has that value");
  command.texts("--ignore", o->ignored, "PIN", "An output that is not compared");
  command.texts("--map", o->renamed, "OLD=NEW", "A port of another name in the new RTL");
  command.text("--latency", o->latency, "N", "The new outputs come N clocks later");
  command.flag("--netlists", o->netlists,
               "A difference is replayed on the netlists alone, not in Verilator: quicker");
  command.text("--seconds", o->seconds, "N", "For all of it, reading included; default 300");
  command.text("--jobs", o->jobs, "J",
               "Engines at a time; default 4, or one a core where there are more");
  command.text("--report", o->report, "FILE", "The result as JSON");
  add_failures(command, o->common);
  command.footer(
      fmt::format("Needs yosys. Exit status: 0 equal, 1 different, 2 bad input, 3 undecided.\n"
                  "Example: {} equiv --gold old/uart.v --gate uart.v --top uart",
                  program_name()));
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli

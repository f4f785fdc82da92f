// PROGRAM lint: what Verilator, Icarus Verilog and yosys find in the RTL of the built machines.
#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/cli/verdicts.h"
#include "tb/full/commands.h"
#include "tb/full/machine_of.h"
#include "tb/util/output_file.h"
#include "tb/util/pattern.h"
#include "tb/util/process.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

using Words = std::vector<std::string>;

// What the sources, folders and definitions are called by Verilator and Icarus Verilog alike.
void add_files(Words& words, const proof::Source& source) {
  for (const auto& folder : source.include_dirs) words.push_back("-I" + folder.string());
  for (const auto& define : source.defines) words.push_back("-D" + define);
  for (const auto& file : source.files) words.push_back(file.string());
}

// A parameter's value as both take it: a text in quotes.
std::string given(const Parameter& p) {
  return p.text != nullptr ? fmt::format("\"{}\"", p.text) : to_text(p);
}

Words verilator(const proof::Source& source) {
  Words words{"verilator",      "--lint-only",  "-Wall",   "--no-timing",
              "-Wno-ASSIGNDLY", "--top-module", source.top};
  for (const Parameter& p : source.parameters) {
    words.push_back(fmt::format("-G{}={}", p.name, given(p)));
  }
  add_files(words, source);
  return words;
}

Words iverilog(const proof::Source& source, const Scratch& scratch, const char* language) {
  Words words{"iverilog", "-Wall", language, "-s", source.top, "-o", scratch.path() / "vvp"};
  for (const Parameter& p : source.parameters) {
    words.push_back(fmt::format("-P{}.{}={}", source.top, p.name, given(p)));
  }
  add_files(words, source);
  return words;
}

Words yosys(const proof::Source& source) {
  const std::string commands =
      commands_to_elaborate(source) +
      "; proc; check -assert; select -assert-none t:$dlatch* t:$adlatch* t:$sr; opt; check -assert";
  return {"yosys", "-q", "-p", commands};
}

// What the tool says, but for Verilator's report of what it has done.
std::string findings(const Ended& ended) {
  std::string text;
  for (const std::string& line : lines_in(ended.text)) {
    const bool report =
        line.starts_with("- V e r i l a t i o n") || line.starts_with("- Verilator:");
    if (!report) text += line + '\n';
  }
  if (text.empty() && ended.status != 0) text = fmt::format("status {}\n", ended.status);
  return text;
}

// Whether Verilator reads it: all that it may have is warnings.
bool is_read(const Ended& ended) {
  static const Pattern error(R"((^|\n)%Error(?!: Exiting due to \d+ warning))");
  return ended.status != 127 && !error.in(ended.text);
}

// The line in which Icarus Verilog or yosys says that it cannot read a file; empty where it can.
std::string unread(const Ended& ended) {
  static const Pattern line(R"([^\n]+:\d+: (syntax error|sorry: |ERROR: )[^\n]*)");
  const auto lines = line.all(ended.text);
  return ended.status == 0 || lines.empty() ? "" : lines.front().front();
}

// What they leave where they are stopped, and what yosys keeps in a home, goes with the scratch.
Ended run_in(const Scratch& scratch, const Words& arguments) {
  const std::string own = scratch.path().string();
  Words command{"env", "HOME=" + own, "TMPDIR=" + own};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return cosim::run_program(command);
}

struct LintOptions {
  Common common;
  Words words;
  Text sarif;
};

int run(const LintOptions& o, Verdicts& verdicts) {
  const InterruptGuard interrupts;
  bool clean = true;
  std::vector<std::string> tools;
  std::vector<ci::Finding> all;
  for (const AnyBench* bench : chosen_shapes(o.words)) {
    const Scratch scratch;
    proof::Source source = machine_of(*bench).source;
    source.parameters = bench->parameters();
    bool verilator_reads = false, is_2005 = false;
    for (const std::string tool : {"verilator -Wall", "iverilog -Wall", "yosys check"}) {
      const bool is_verilator = tool.starts_with("verilator"), is_yosys = tool.starts_with("yosys");
      const Words arguments = is_verilator ? verilator(source)
                              : is_yosys   ? yosys(source)
                                         : iverilog(source, scratch, is_2005 ? "-g2005" : "-g2012");
      Ended ended = run_in(scratch, arguments);
      if (is_verilator && ended.status != 127 && !is_read(ended)) {
        // A word of SystemVerilog may be a name in a file .v.
        Words older = arguments;
        older.insert(older.begin() + 1, "+1364-2005ext+v");
        if (Ended again = run_in(scratch, older); is_read(again)) {
          ended = std::move(again);
          is_2005 = true;
          fmt::print(
              "{:<24} files .v are read as Verilog-2005: Verilator does not read them as "
              "SystemVerilog\n",
              bench->built_as());
        }
      }
      std::string result = "clean";
      ci::Verdict verdict{bench->built_as() + ", " + tool};
      if (ended.status == 127) {
        result = "skipped: not installed";
      } else if (const std::string line = unread(ended); verilator_reads && !line.empty()) {
        result = "skipped: it does not read this: " + line;
      } else if (const std::string text = findings(ended); !text.empty()) {
        result = "findings:\n" + text;
        result.pop_back();
        clean = false;
        verdict.end = ci::Verdict::End::failure;
        verdict.type = "findings";
        verdict.text = text;
        const auto found = ci::findings_in(tool, text);
        all.insert(all.end(), found.begin(), found.end());
      }
      if (ended.status != 127 && std::ranges::find(tools, tool) == tools.end()) {
        tools.push_back(tool);
      }
      if (verdict.text.empty()) verdict.text = result;
      verdicts.add(verdict);
      if (is_verilator) verilator_reads = is_read(ended);
      fmt::print("{:<24} {:<16} {}\n", bench->built_as(), tool, result);
    }
  }
  if (ci::is_on_github()) {
    for (const ci::Finding& one : all) fmt::print("{}", ci::annotation(one));
  }
  if (o.sarif) write_file(*o.sarif, ci::sarif_text(tools, all));
  return clean ? 0 : 1;
}

}  // namespace

void add_lint(const Command& program) {
  auto o = std::make_shared<LintOptions>();
  const Command command = program.sub(lint_command.name, lint_command.help);
  command.arguments("MACHINE", o->words, "A design, or a line of 'list'; default all");
  add_junit(command, o->common);
  command.text("--sarif", o->sarif, "FILE", "Write the findings with their places as SARIF 2.1.0");
  command.footer(fmt::format(
      "Runs Verilator with all warnings, and Icarus Verilog and yosys where they are installed\n"
      "and read the RTL.\n"
      "Exit status: 0 no finding, 1 findings, 2 bad input.\n"
      "Example: {} lint {}",
      program_name(), benches().front()->design()));
  command.action([o] {
    return with_verdicts(lint_command.name, lint_command.name, o->common,
                         [&](Verdicts& verdicts) { return run(*o, verdicts); });
  });
}

}  // namespace cosim::cli

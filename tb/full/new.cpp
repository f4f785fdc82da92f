// cosim new: a project around a design of one's own.
#include "tb/new/new.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "model/core/input_error.h"
#include "tb/cli/named_values.h"
#include "tb/full/begin_project.h"
#include "tb/full/commands.h"
#include "tb/rtl/file_list.h"
#include "tb/util/draft.h"
#include "tb/util/pattern.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

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
    design = design_of(name, found, rtl.sources, model, rtl.headers, rtl.defines, o.blackboxes);
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
  for (const std::string& note : rtl.notes) fmt::print("{}: {}\n", name, note);
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
               "A parameter of the top, a number or a word: the configuration that is\n"
               "built; or a type or another constant of SystemVerilog, T=pkg::bus_t: a\n"
               "wrapper has it.\n"
               "PORT.NAME=VALUE: a parameter of the interface at that port");
  command.each("--include", o->includes, "DIR", "A folder with the headers that `include names");
  command.each("--define", o->defines, "NAME[=VALUE]", "A macro of the preprocessor");
  command.each("--blackbox", o->blackboxes, "NAME",
               "A module that no file has: its outputs become inputs of the design, its\n"
               "inputs outputs");
  command.each("-y", o->libraries, "DIR",
               "A folder with further modules, of which those needed are taken");
  command.each("-f", o->lists, "LIST",
               "Files, +incdir+DIR, +define+NAME=VALUE, -y DIR, -v FILE, -f LIST");
  command.each("-F", o->own_lists, "LIST", "The same, whose paths begin at the folder of the list");
  command.footer(
      fmt::format("Example: {} new adder adder.v\n"
                  "         {} new fifo rtl/ --top axis_fifo --param DEPTH=16",
                  program_name(), program_name()));
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli

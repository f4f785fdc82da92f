#include "tb/equiv/front_end.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "model/core/input_error.h"
#include "tb/equiv/assertions.h"
#include "tb/equiv/misread.h"
#include "tb/equiv/prints.h"
#include "tb/equiv/reading.h"
#include "tb/equiv/sources.h"
#include "tb/equiv/yosys_messages.h"
#include "tb/util/output_file.h"
#include "tb/util/pattern.h"
#include "tb/util/quoted.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

namespace fs = std::filesystem;

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

// How much of a file yosys is given.
struct Shown {
  bool prints = true;   ///< what is printed
  bool pragmas = true;  ///< what stands between the comments translate_off and translate_on
};

std::string for_yosys(const fs::path& file, const Shown& shown) {
  const bool is_sv = Reading::extension(file) == ".sv";
  const std::string own = read_file(file.string());
  std::string text = with_casts_apart(is_sv ? without_assertions(own) : own);
  text = with_resets_apart(without_macro_of_yosys(text));
  if (shown.pragmas) text = without_pragmas(text);
  return shown.prints ? text : simpler(text);
}

std::string script(const Files& files, Reading& reading, const fs::path& scratch,
                   const Shown& shown, const char* processes) {
  std::string options = " -defer -D SYNTHESIS", commands;
  for (const fs::path& folder : reading.folders()) options += " -I" + folder.string();
  for (const std::string& define : files.defines) options += " -D" + define;
  for (std::size_t i = 0; i < files.files.size(); ++i) {
    const bool is_system_verilog = Reading::extension(files.files[i]) == ".sv";
    commands += fmt::format("read_verilog{}{} {}\n", is_system_verilog ? " -sv" : "", options,
                            reading.file(i, for_yosys(files.files[i], shown)));
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
    const std::string above = unused_name("cosim_top", sources_of(files));
    write_file((scratch / "parameters.v").string(),
               fmt::format("module {}; {} #({}) cosim_dut(); endmodule\n", above, files.top, list));
    commands += fmt::format(
        "read_verilog -sv {0}/parameters.v\nhierarchy -check -top {1}\ndelete {1}\n"
        "hierarchy -auto-top\n",
        scratch.string(), above);
  }
  // What a function returns keeps its name, by which it is known where it may be an old one; but a
  // register that nothing reads, as in a clocked block, goes.
  const char* results = "\nsetattr -set keep 1 w:*$func$*$result t:*dff* %co1:+[Q] %d";
  return commands + processes + results + to_cells +
         fmt::format("write_json {0}/top.json\nwrite_rtlil {0}/top.il\n", scratch.string());
}

Elaborated by_yosys(const Files& files, const std::string& what, const Budget& budget) {
  refuse_misread(sources_of(files), FrontEnd::yosys);
  const Scratch scratch;
  const fs::path own = scratch.path();
  Reading reading(files, own);
  const std::string log = (own / "log").string();
  const char* processes = has_items_with_x(files) ? without_rmdead : with_rmdead;
  const auto attempt = [&](const Shown& shown, const fs::path& folder) {
    write_file((own / "script.ys").string(), script(files, reading, own, shown, processes));
    const Ended ended = run_reader({"yosys", "-q", "-l", log, "-s", (own / "script.ys").string()},
                                   own, folder, budget);
    if (ended.status == 127) throw InputError("needs yosys");
    if (ended.status != 0) {
      // Its log says more, as which register it was at.
      const std::string said = fs::exists(log) ? read_file(log) : ended.text;
      static const Pattern given(R"(^\S*/parameters\.v:\d+: (?:Parameter cosim_dut\.(\S+): )?)");
      const std::string why =
          given.replaced(yosys_message(said, ended.status, reading.names()), "--param $1: ");
      throw InputError(fmt::format("{}: yosys cannot read it: {}", what, why));
    }
    std::string wrong = misread(ended.text, reading);
    if (wrong.empty()) wrong = cut_on_a_port(ended.text, sources_of(files));
    if (!wrong.empty()) throw InputError(fmt::format("{}: yosys cannot read it: {}", what, wrong));
  };
  const fs::path empty = own / "empty";
  fs::create_directory(empty);
  const auto any_of_files = [&](const auto& is_so) {
    return std::ranges::any_of(
        files.files, [&](const fs::path& file) { return is_so(read_file(file.string())); });
  };
  // It may be what is printed that it does not read, or a file of $readmemh that is not beside the
  // RTL but where one works.
  std::optional<InputError> first;
  std::vector<fs::path> folders{empty, fs::absolute(files.folder)};
  // A file that is not read itself is not beside its files of $readmemh.
  for (const fs::path& file : files.files) {
    const fs::path folder = fs::absolute(file).parent_path();
    const bool is_there = std::ranges::find(folders, folder) != folders.end();
    if (!is_there && for_yosys(file, {}) != read_file(file.string())) folders.push_back(folder);
  }
  std::vector<Shown> ways{{true, true}};
  if (any_of_files([](const std::string& text) { return simpler(text) != text; }))
    ways.push_back({false, true});
  const bool has_pragmas =
      any_of_files([](const std::string& text) { return without_pragmas(text) != text; });
  if (has_pragmas && !any_of_files([](const auto& text) { return !hides_simulation(text); }))
    ways.push_back({true, false});
  for (const Shown& shown : ways) {
    for (const fs::path& folder : folders) {
      try {
        attempt(shown, folder);
        const auto has_latch = [&] {
          return read_file((own / "top.json").string()).find("\"$dlatch") != std::string::npos;
        };
        if (processes == without_rmdead && has_latch()) {
          processes = with_rmdead;
          attempt(shown, folder);
        }
        return {read_file((own / "top.json").string()), read_file((own / "top.il").string())};
      } catch (const InputError& error) {
        if (!first) first = error;
      }
    }
  }
  throw InputError(first->what());
}

}  // namespace

Elaborated elaborated(const Files& files, const std::string& what, FrontEnd front_end,
                      const Budget& budget) {
  return front_end == FrontEnd::yosys ? by_yosys(files, what, budget)
                                      : elaborated_by_slang(files, what, budget);
}

}  // namespace cosim::equiv

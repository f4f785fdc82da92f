#include "tb/equiv/front_end.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "model/core/input_error.h"
#include "tb/equiv/assertions.h"
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

// Verilog knows no such comments, and yosys leaves out what is between them.
std::string without_pragmas(const std::string& text) {
  static const Pattern pragma(R"(((?:synopsys|synthesis)[ \t]*)translate_(off|on))");
  return pragma.replaced(text, "$1translate-$2");
}

// Whether such parts are of simulation alone, as far as one can see.
bool hides_simulation(const std::string& text) {
  static const Pattern hidden(R"((?:synopsys|synthesis)[ \t]*translate_off([^]*?)translate_on)"),
      simulation(R"(\$[a-z]|\binitial\b)");
  const auto parts = hidden.all(text);
  return std::ranges::all_of(parts, [](const auto& part) { return simulation.in(part[1]); });
}

std::string for_yosys(const fs::path& file, const Shown& shown) {
  const bool is_sv = Reading::extension(file) == ".sv";
  const std::string own = read_file(file.string());
  std::string text = with_casts_apart(is_sv ? without_assertions(own) : own);
  if (shown.pragmas) text = without_pragmas(text);
  return shown.prints ? text : simpler(text);
}

// What yosys reads in another way than Verilog says, without a word. Files that are included are
// read as they are.
void refuse_misread(const std::vector<SourceText>& sources) {
  for (const SourceText& one : sources) {
    if (one.is_included && with_casts_apart(one.text) != one.text) {
      throw InputError(fmt::format(
          "{}: an operator before a cast, as |5'(x), which yosys misreads in a file that is "
          "included: put brackets around the cast",
          one.file.string()));
    }
    if (one.is_included && without_pragmas(one.text) != one.text) {
      throw InputError(fmt::format(
          "{}: translate_off in a file that is included: yosys leaves out what Verilog does not",
          one.file.string()));
    }
  }
  const auto refuse = [&](const char* expression, const char* what) {
    const std::string place = place_of(sources, expression);
    if (!place.empty()) throw InputError(fmt::format("{}: yosys misreads {}", place, what));
  };
  refuse("\\btask\\b[^;(]*\\([^;)]*\\binout\\b", "a task with an inout argument");
  refuse("\\btask\\b[^;(]*;(\\s*(input|output|reg|integer)\\b[^;]*;)*\\s*inout\\b",
         "a task with an inout argument");
  refuse("\\bbind\\s+[A-Za-z_]", "bind");
  refuse("\\b(tri0|tri1|trireg)\\b", "tri0, tri1 and trireg");
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
  refuse_misread(sources_of(files));
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
      throw InputError(fmt::format("{}: yosys cannot read it: {}", what,
                                   yosys_message(said, ended.status, reading.names())));
    }
    const std::string wrong = misread(ended.text, reading);
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

std::string revealed(const std::string& text) {
  return hides_simulation(text) ? text : without_pragmas(text);
}

Elaborated elaborated(const Files& files, const std::string& what, FrontEnd front_end,
                      const Budget& budget) {
  return front_end == FrontEnd::yosys ? by_yosys(files, what, budget)
                                      : elaborated_by_slang(files, what, budget);
}

}  // namespace cosim::equiv

#include "tb/equiv/simulator.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "tb/equiv/assertions.h"
#include "tb/equiv/for_icarus.h"
#include "tb/equiv/sources.h"
#include "tb/equiv/verilated.h"
#include "tb/rtl/design.h"
#include "tb/rtl/verilog.h"
#include "tb/util/output_file.h"
#include "tb/util/pattern.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

namespace fs = std::filesystem;

bool is_system_verilog(const Files& files) {
  return std::any_of(files.files.begin(), files.files.end(),
                     [](const fs::path& file) { return file.extension() == ".sv"; });
}

// The first line that says what is wrong.
std::string reason(const std::string& said, const std::string& own) {
  if (said.find("Verilator internal fault") != std::string::npos) {
    return "it ends with a fault of its own, and names no line";
  }
  for (std::string line : lines_in(said)) {
    if (line.find("rror") == std::string::npos && line.find("sorry") == std::string::npos) continue;
    if (line.starts_with(own + "/cosim_replay.v")) continue;
    return one_line(line);
  }
  const std::string first = said.empty() ? "" : one_line(lines_in(said).front());
  return first.starts_with(own) ? "the testbench: " + first.substr(own.size() + 1) : first;
}

}  // namespace

const char* name_of(Simulator simulator) {
  return simulator == Simulator::icarus      ? "Icarus Verilog"
         : simulator == Simulator::verilator ? "Verilator"
                                             : "GHDL";
}

Program::Program(const Side& side, Stimulus stimulus, Simulator simulator,
                 std::chrono::steady_clock::time_point until)
    : side_(side),
      stimulus_(std::move(stimulus)),
      simulator_(simulator),
      own_(scratch_.path().string()),
      bench_(unused_name("cosim_replay", sources_of(side.files()))) {
  if (!stimulus_.vcd.empty()) stimulus_.vcd = own_ + "/wave.vcd";
  std::string rows;
  for (const std::string& row : stimulus_.rows) rows += (row.empty() ? "0" : row) + '\n';
  // Verilator reads no x from a file.
  if (simulator_ == Simulator::verilator) std::ranges::replace(rows, 'x', '0');
  write_file(own_ + "/rows", rows);
  fs::create_directory(own_ + "/empty");
  // Delays of RTL without a timescale are short beside a clock of the testbench.
  write_file(own_ + "/timescale.v", "`timescale 1ns/1ps\n");
  if (simulator_ == Simulator::verilator) {
    stimulus_.variables.clear();
    stimulus_.memories.clear();
    stimulus_.states.clear();
  }
  std::string states;
  for (const std::string& state : stimulus_.states) states += state + '\n';
  write_file(own_ + "/states", states);
  copy_simpler();
  // Verilog-2005 has fewer keywords; but some files are SystemVerilog whatever their names are.
  std::vector<std::string> generations{"-g2005", "-g2012"};
  if (simulator_ == Simulator::verilator || is_system_verilog(side.files())) {
    generations.erase(generations.begin());
  }
  for (const std::string& generation : generations) {
    constexpr int attempts = 6;
    for (int i = 0; i < attempts; ++i) {
      std::map<std::size_t, std::string> line_of;
      write_file(own_ + "/cosim_replay.v", testbench(side_, stimulus_, bench_, own_, line_of));
      const Ended built = build(generation, until);
      if (built.timed_out) throw OutOfTime();
      why_not_.clear();
      if (built.status == 0) return;
      why_not_ = built.status == 127 ? fmt::format("{} is not installed", name_of(simulator_))
                                     : by_own_names(reason(built.text, own_));
      static const Pattern array("port connection .* port which is an array");
      if (array.in(built.text) && stimulus_.arrays.empty()) {
        find_arrays(until);
        if (!stimulus_.arrays.empty()) continue;
      }
      if (!leave_out(built.text, std::move(line_of))) break;
    }
  }
}

// What a simulator is given in place of a file, where it does not read that as it should.
void Program::copy_simpler() {
  std::vector<std::string> files;
  for (const fs::path& one : side_.files().files) files.push_back(fs::absolute(one).string());
  const auto given = rtl::without_port_defaults("/", files, fs::path(own_) / "ports");
  for (std::size_t i = 0; i < files.size(); ++i) {
    const fs::path& one = side_.files().files[i];
    const std::string text = read_file(one.string()), own = read_file(given[i]);
    std::string simpler = one.extension() == ".sv" ? without_assertions(own) : own;
    if (simulator_ == Simulator::icarus) simpler = for_icarus(simpler);
    if (simpler == text) continue;
    std::string& copy = copies_[fs::absolute(one).string()];
    copy = fmt::format("{}/source{}{}", own_, copies_.size(), one.extension().string());
    write_file(copy, simpler);
  }
}

// A text with the files that a person knows in place of their copies.
std::string Program::by_own_names(std::string text) const {
  for (const auto& [file, copy] : copies_) {
    if (const std::size_t at = text.find(copy); at != std::string::npos) {
      text.replace(at, copy.size(), file);
    }
  }
  return text;
}

// The words of definitions, of folders and of files.
std::vector<std::string> Program::sources(const char* define, const char* folder) const {
  const Files& files = side_.files();
  std::vector<std::string> words;
  const auto look_in = [&](const fs::path& path) {
    words.push_back(folder + fs::absolute(path).string());
  };
  for (const std::string& one : files.defines) words.push_back(define + one);
  for (const fs::path& one : files.files) look_in(fs::absolute(one).parent_path());
  for (const fs::path& one : files.include_dirs) look_in(one);
  look_in(files.folder);
  words.push_back(own_ + "/timescale.v");
  for (const fs::path& one : files.files) {
    const std::string file = fs::absolute(one).string();
    const auto copy = copies_.find(file);
    words.push_back(copy == copies_.end() ? file : copy->second);
  }
  return words;
}

// Asks Verilator which ports are arrays.
void Program::find_arrays(std::chrono::steady_clock::time_point until) {
  const auto run = [&](const std::vector<std::string>& words) {
    const Ended ended = run_until(words, until);
    if (ended.timed_out) throw OutOfTime();
    return rtl::Ran{ended.status, ended.text};
  };
  const std::string tree = own_ + "/tree";
  std::vector<std::string> words =
      words_in("env -C " + own_ + "/empty verilator -Wno-fatal -Wno-lint -Wno-style --no-timing " +
               "+define+SYNTHESIS --Mdir " + own_ + "/read --top-module " + side_.files().top);
  for (const auto& more :
       {rtl::tree_options("verilator", run), {tree}, sources("+define+", "+incdir+")})
    words.insert(words.end(), more.begin(), more.end());
  for (const std::string& one : side_.files().parameters) words.push_back("-G" + one);
  if (run(words).status != 0) return;
  const rtl::Tree read(tree);
  const rtl::Design design(read);
  for (const rtl::Node* port : design.top().in) {
    if (!port->is_port()) continue;
    const std::string& name = port->has("name");
    auto sizes = design.unpacked(port->has("dtype_id")).first;
    const bool is_known = side_.inputs.contains(name) || side_.outputs.contains(name);
    if (is_known && !sizes.empty()) stimulus_.arrays[name] = std::move(sizes);
  }
}

std::vector<std::string> Program::command(const std::string& generation) const {
  std::vector<std::string> words{"env", "-C", own_ + "/empty"};
  const bool is_icarus = simulator_ == Simulator::icarus;
  const std::vector<std::string> begins =
      words_in(is_icarus ? "iverilog -grelative-include -DSYNTHESIS -s " + bench_ + " -o " + own_ +
                               "/built.vvp " + generation
                         : "verilator --cc --exe --main --timing -Wno-fatal -Wno-lint -Wno-style "
                           "--x-initial unique "
                           "--x-assign unique --timescale 1ns/1ps --top-module " +
                               bench_ + " --prefix Vcosim_replay +define+SYNTHESIS --Mdir " + own_ +
                               "/built" + (stimulus_.vcd.empty() ? "" : " --trace"));
  words.insert(words.end(), begins.begin(), begins.end());
  const auto more = sources(is_icarus ? "-D" : "+define+", is_icarus ? "-I" : "+incdir+");
  words.insert(words.end(), more.begin(), more.end());
  words.push_back(own_ + "/cosim_replay.v");
  return words;
}

// Runs the compiler of the simulator.
Ended Program::build(const std::string& generation,
                     std::chrono::steady_clock::time_point until) const {
  Ended made = run_until(command(generation), until);
  if (made.status != 0 || made.timed_out || simulator_ == Simulator::icarus) return made;
  const std::string built = own_ + "/built";
  const VerilatedLibrary library(built);
  library.put();
  made = run_until(
      words_in("make -s -C " + built + " -f Vcosim_replay.mk -j2 OPT_FAST= OPT_GLOBAL="), until);
  if (made.status == 0) library.keep();
  return made;
}

// Those of which a line of the testbench is wrong; whether there are any.
bool Program::leave_out(const std::string& said, std::map<std::size_t, std::string> line_of) {
  static const Pattern place(R"(cosim_replay\.v:(\d+):)");
  std::set<std::string> names;
  for (const Pattern::Parts& part : place.all(said)) {
    if (const auto at = line_of.find(std::stoul(part[1])); at != line_of.end()) {
      names.insert(at->second);
    }
  }
  std::erase_if(stimulus_.variables, [&](const Variable& one) { return names.contains(one.name); });
  for (Variable& one : stimulus_.variables) {
    if (names.contains(one.name + '@')) one.is_loaded = false;
    if (!names.contains(one.name + '=') || one.value.empty()) continue;
    one.name.clear();  // a net: what drives it is given a value where it stands
  }
  std::erase_if(stimulus_.variables, [](const Variable& one) { return one.name.empty(); });
  std::erase_if(stimulus_.memories, [&](const Contents& one) { return names.contains(one.name); });
  return !names.empty();
}

// A file of $readmemh is found beside the RTL, or from the working directory.
Simulated Program::run(std::chrono::steady_clock::time_point until, const char* begins) const {
  std::vector<fs::path> folders;
  for (const fs::path& file : side_.files().files) {
    const fs::path folder = fs::absolute(file).parent_path();
    if (std::ranges::find(folders, folder) == folders.end()) folders.push_back(folder);
  }
  folders.push_back(fs::absolute(side_.files().folder));
  Ended ended;
  const std::string written = own_ + "/lines";
  for (const fs::path& folder : folders) {
    fs::remove(written);
    std::vector<std::string> words{"env", "-C", folder.string()};
    if (simulator_ == Simulator::icarus) {
      words.insert(words.end(), {"vvp", "-n", own_ + "/built.vvp"});
    } else {
      words.insert(words.end(),
                   {own_ + "/built/Vcosim_replay", std::string("+verilator+rand+reset+") + begins,
                    "+verilator+seed+1"});
    }
    ended = run_until(words, until);
    const bool is_missing = ended.text.find("$readmem file not found") != std::string::npos ||
                            (ended.text.find("$readmem") != std::string::npos &&
                             ended.text.find("Unable to open") != std::string::npos);
    if (!is_missing) break;
  }
  Simulated is;
  for (const std::string& line : lines_in(fs::exists(written) ? read_file(written) : "")) {
    std::vector<std::string> words = words_in(line);
    if (words.empty()) continue;
    if (words[0] == "cosim_done") is.is_complete = true;
    if (words[0] == "cosim_replay") {
      is.clocks.emplace_back(words.begin() + 1, words.end());
    } else if (words.size() == 3 && words[0] == "cosim_before") {
      is.before[words[1]] = words[2];
    } else if (words.size() == 3 && words[0] == "cosim_after") {
      is.after[words[1]] = words[2];
    } else if (words.size() == 3 && words[0] == "cosim_word") {
      is.memories[words[1]].push_back(words[2]);
    }
  }
  const std::size_t many =
      stimulus_.outputs.size() + stimulus_.further.size() + stimulus_.variables.size();
  while (!is.clocks.empty() && is.clocks.back().size() != many) is.clocks.pop_back();
  if (!is.is_complete) is.why = by_own_names(reason(ended.text, own_));
  return is;
}

std::string Program::wave() const {
  const std::string file = own_ + "/wave.vcd";
  return fs::exists(file) ? read_file(file) : "";
}

}  // namespace cosim::equiv

#include "tb/equiv/replay.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>
#include <vector>

#include "tb/support/output_file.h"
#include "tb/support/parallel.h"
#include "tb/support/process.h"

namespace cosim::equiv {
namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::vector<std::string>>;  // words of outputs, a line a clock

std::string range(int width) { return width == 1 ? "" : fmt::format("[{}:0] ", width - 1); }

// What one side prints for each way to begin; none where Verilator cannot build it.
std::optional<std::vector<Lines>> runs(const Question& q, const Answer& a, bool is_gate) {
  const Scratch scratch;
  const Files& files = (is_gate ? q.gate : q.gold).files();
  const std::string own = scratch.path().string();
  OutputFile file(own + "/cosim_replay.v");
  file.text(testbench(q, a, is_gate, own + "/rows"));
  file.close();
  OutputFile rows(own + "/rows");
  rows.text(stimulus_rows(q, a, is_gate));
  rows.close();
  std::vector<std::string> words{
      "env",          "-C",           files.folder.string(), "verilator",        "--binary",
      "-Wno-fatal",   "-Wno-lint",    "-Wno-style",          "--x-initial",      "unique",
      "--x-assign",   "unique",       "--timescale",         "1ns/1ps",          "--Mdir",
      own + "/built", "--top-module", "cosim_replay",        "+define+SYNTHESIS"};
  for (const std::string& define : files.defines) words.push_back("+define+" + define);
  for (const fs::path& folder : files.include_dirs) {
    words.push_back("+incdir+" + fs::absolute(folder).string());
  }
  for (const fs::path& one : files.files) {
    words.push_back("+incdir+" + fs::absolute(one).parent_path().string());
    words.push_back(fs::absolute(one).string());
  }
  words.push_back(own + "/cosim_replay.v");
  for (const char* word : {"-MAKEFLAGS", "OPT_FAST= OPT_GLOBAL="}) words.emplace_back(word);
  // Verilator's own library is the same each time.
  if (is_installed("ccache")) words.insert(words.begin() + 3, "OBJCACHE=ccache");
  const Ended built = run_until(words, q.budget.ends());
  if (built.timed_out) throw OutOfTime();
  if (built.status != 0) return std::nullopt;
  std::vector<Lines> all;
  for (const char* begins : {"0", "1", "2"}) {
    const Ended ended =
        run_until({"env", "-C", files.folder.string(), own + "/built/Vcosim_replay",
                   std::string("+verilator+rand+reset+") + begins, "+verilator+seed+1"},
                  q.budget.ends());
    if (ended.timed_out) throw OutOfTime();
    if (ended.status != 0) return std::nullopt;
    Lines lines;
    std::istringstream text(ended.text);
    for (std::string line, word; std::getline(text, line);) {
      std::istringstream in(line);
      if (!(in >> word) || word != "cosim_replay") continue;  // what the RTL itself prints
      lines.emplace_back();
      while (in >> word) lines.back().push_back(word);
    }
    all.push_back(std::move(lines));
  }
  return all;
}

// Whether an output that is compared differs on the last clock.
bool differs(const Question& q, const Answer& a, const Lines& gold, const Lines& gate) {
  const auto last = a.clocks.size(), then = last - static_cast<std::size_t>(q.latency);
  if (gold.size() < then || gate.size() < last) return false;
  std::size_t at = 0;
  for (const auto& [port, text] : a.clocks.back().gold) {
    const std::string &old = gold[then - 1].at(at), &now = gate[last - 1].at(at);
    ++at;
    if (std::find(a.differing.begin(), a.differing.end(), port) == a.differing.end()) continue;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] != '-' && old[i] != now[i]) return true;
    }
  }
  return false;
}

}  // namespace

std::string stimulus_rows(const Question& q, const Answer& a, bool is_gate) {
  const Side& side = is_gate ? q.gate : q.gold;
  std::string text;
  for (const Row& row : a.clocks) {
    std::string bits;
    for (const auto& [port, value] : row.inputs) {
      const auto other = q.renamed.find(port);
      const bool is_other = is_gate && other != q.renamed.end();
      if (side.inputs.contains(is_other ? other->second : port)) bits += value;
    }
    std::replace(bits.begin(), bits.end(), '-', '0');
    text += (bits.empty() ? "0" : bits) + '\n';
  }
  return text;
}

std::string testbench(const Question& q, const Answer& a, bool is_gate, const std::string& rows) {
  const Side& side = is_gate ? q.gate : q.gold;
  const auto own_name = [&](const std::string& port) {
    const auto at = q.renamed.find(port);
    return is_gate && at != q.renamed.end() ? at->second : port;
  };
  // Long beside the delays that RTL may have.
  std::string text = "`timescale 1us/1ps\nmodule cosim_replay;\n", pins, inputs, outputs, formats;
  const auto pin = [&](const std::string& port, const std::string& is) {
    pins += fmt::format("{}.{}({})", pins.empty() ? "" : ", ", port, is);
  };
  for (const auto& [port, width] : side.inputs) {
    if (const auto tied = q.tied.find(port); tied != q.tied.end()) {
      pin(port, fmt::format("{}'d{}", width, tied->second));
    } else if (port == side.clock) {
      pin(port, "cosim_clock");
    }
  }
  const Row& first = a.clocks.front();
  for (const auto& [port, value] : first.inputs) {
    const std::string own = own_name(port);
    if (!side.inputs.contains(own)) continue;
    text += fmt::format("  reg {}in_{};\n", range(side.inputs.at(own)), own);
    pin(own, "in_" + own);
    inputs += fmt::format("{}in_{}", inputs.empty() ? "" : ", ", own);
  }
  for (const auto& [port, value] : first.gold) {
    const std::string own = own_name(port);
    text += fmt::format("  wire {}out_{};\n", range(side.outputs.at(own)), own);
    pin(own, "out_" + own);
    outputs += ", out_" + own;
    formats += " %b";
  }
  std::string parameters;
  for (const std::string& one : side.files().parameters) {
    const std::size_t at = one.find('=');
    parameters += fmt::format("{}.{}({})", parameters.empty() ? "" : ", ", one.substr(0, at),
                              one.substr(at + 1));
  }
  if (!parameters.empty()) parameters = "#(" + parameters + ") ";
  const int rests = side.falling ? 1 : 0;
  std::size_t bits = 0;
  for (const auto& [port, value] : first.inputs) {
    if (side.inputs.contains(own_name(port))) bits += value.size();
  }
  text += fmt::format("  integer cosim_i;\n  reg [{}:0] cosim_rows[0:{}];\n",
                      std::max<std::size_t>(bits, 1) - 1, a.clocks.size() - 1);
  text += fmt::format("  reg cosim_clock = {};\n  {} {}cosim_dut({});\n  initial begin\n", rests,
                      side.files().top, parameters, pins);
  text += fmt::format(
      "    $readmemb(\"{}\", cosim_rows);\n    for (cosim_i = 0; cosim_i < {}; cosim_i = cosim_i + "
      "1)"
      " begin\n",
      rows, a.clocks.size());
  if (!inputs.empty()) text += fmt::format("      {{{}}} = cosim_rows[cosim_i];\n", inputs);
  return text + fmt::format(
                    "      #1 $display(\"cosim_replay{}\"{});\n      cosim_clock = {};\n      #1"
                    " cosim_clock = {};\n    end\n    $finish;\n  end\nendmodule\n",
                    formats, outputs, 1 - rests, rests);
}

Replay replayed(const Question& q, const Answer& a) {
  if (!q.verilator) return {false, false, "on the netlists"};
  if (!is_installed("verilator")) return {false, false, "on the netlists: there is no Verilator"};
  std::optional<std::vector<Lines>> gold, gate;
  try {
    in_parallel(2, q.jobs, [&](std::uint64_t i) {
      (i == 0 ? gold : gate) = runs(q, a, i == 1);
      return true;
    });
  } catch (const OutOfTime&) {
    return {false, false, "on the netlists: no time was left for Verilator"};
  }
  if (!gold || !gate) {
    return {
        false, false,
        fmt::format("on the netlists: Verilator does not build the {} RTL", gold ? "new" : "old")};
  }
  for (const Lines& old : *gold) {
    for (const Lines& now : *gate) {
      if (differs(q, a, old, now)) return {true, false, "in Verilator"};
    }
  }
  const auto is_any = [](const Register& r) { return r.any; };
  for (const Side* s : {&q.gold, &q.gate}) {
    if (s->unknowns > 0 || std::any_of(s->registers.begin(), s->registers.end(), is_any)) {
      return {false, false, "on the netlists: Verilator has other values for what is x"};
    }
  }
  return {false, true, "in Verilator, which shows no difference"};
}

}  // namespace cosim::equiv

#include "tb/equiv/vhdl_run.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "tb/equiv/vhdl_testbench.h"
#include "tb/support/pattern.h"
#include "tb/support/process.h"
#include "tb/support/scratch.h"
#include "tb/support/words.h"

namespace cosim::equiv {
namespace {

// What GHDL says is wrong, with the port where it is a line of the testbench.
std::string vhdl_reason(const std::string& text, const VhdlTestbench& tb) {
  static const Pattern unbound(R"((\S+:\d+):\d+:warning: (.* is not bound).*)"),
      located(R"((\S+:\d+):\d+: ?(?!note|warning)(.*))"), stopped(R"(\S*:error: (.*))"),
      caller(R"(  from: .* at (.*))"), of_testbench(R"(cosim_tb\.vhd:(\d+))");
  std::string said;
  bool is_placed = false;  // in a file, and none of the standard's
  for (const std::string& line : lines_in(text)) {
    Pattern::Parts parts = unbound.whole(line);
    if (parts.empty()) parts = located.whole(line);
    if (parts.empty() && said.empty()) parts = stopped.whole(line);
    if (parts.size() == 3 && said.empty()) said = parts[1] + ": " + parts[2];
    if (parts.size() == 2) said = parts[1];
    is_placed = said.find(" at ") != std::string::npos && said.find("-body.") == std::string::npos;
    parts = caller.whole(line);
    if (said.empty() || is_placed || parts.empty() || parts[1].find("-body.") != std::string::npos)
      continue;
    said += ", from " + parts[1];
    break;
  }
  for (const Pattern::Parts& place : of_testbench.all(said)) {
    const auto port = tb.port_of.find(std::stoul(place[1]));
    if (port == tb.port_of.end()) continue;
    const char* why =
        said.find("bound") != std::string::npos
            ? "its type has no such value, or not so many bits"
            : "its type is not std_logic, bit, boolean, an integer or a vector of these";
    return fmt::format("port {}: {}", port->second, why);
  }
  return said.empty() ? "GHDL ends without a reason" : one_line(said);
}

}  // namespace

VhdlRun run_vhdl(const VhdlLines& files, const std::string& top, const VhdlLines& generics,
                 const VhdlStimulus& stimulus, std::chrono::steady_clock::time_point until) {
  std::optional<VhdlEntity> entity;
  for (const std::string& file : files) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    if (!entity) entity = entity_in(text.str(), top);
  }
  if (!entity) return {{}, {}, fmt::format("no file has the entity {}", top)};
  const Scratch scratch;
  const std::string folder = scratch.path().string();
  const VhdlTestbench tb = vhdl_testbench(*entity, stimulus, folder);
  if (!tb.error.empty()) return {{}, {}, tb.error};
  const std::string bench = folder + "/cosim_tb.vhd", ports = folder + "/cosim_ports.vhd";
  std::ofstream(ports) << vhdl_conversions;
  std::ofstream(bench) << tb.text;
  std::ofstream(folder + "/in") << fmt::format("{}\n", fmt::join(stimulus.rows, "\n"));
  const auto ghdl = [&](const char* command, const VhdlLines& words) {
    VhdlLines all{"ghdl", command, "--std=08", "--workdir=" + folder};
    all.insert(all.end(), words.begin(), words.end());
    return run_until(all, until);
  };
  VhdlLines sources = files, options{"cosim_tb", "--ieee-asserts=disable", "--assert-level=none"};
  sources.insert(sources.end(), {ports, bench});
  for (const std::string& generic : generics) options.push_back("-g" + generic);
  static const Pattern unbound("is not bound");
  Ended ended = ghdl("-i", sources);
  if (ended.status == 0) ended = ghdl("-m", {"cosim_tb"});
  const bool is_open = unbound.in(ended.text);
  if (ended.status == 0 && !is_open) ended = ghdl("-r", options);
  if (ended.status == 127) return {{}, {}, "needs ghdl"};
  VhdlRun run;
  std::size_t bits = vhdl_row_length(stimulus), inputs = bits;
  for (const auto& [name, width] : stimulus.outputs) bits += static_cast<std::size_t>(width);
  std::ifstream out(folder + "/out");
  for (std::string row; std::getline(out, row);) {
    if (row.size() != bits) {
      return {{}, {}, fmt::format("the ports have {} bits in VHDL, not {}", row.size(), bits)};
    }
    run.inputs.push_back(row.substr(0, inputs));
    run.rows.push_back(row.substr(inputs));
  }
  if (ended.timed_out) {
    run.error = "no time was left for GHDL";
  } else if (ended.status != 0 || is_open) {
    run.error = vhdl_reason(ended.text, tb);
  } else if (run.rows.size() < stimulus.rows.size()) {
    run.error = "the VHDL ends its simulation";
  }
  return run;
}

}  // namespace cosim::equiv

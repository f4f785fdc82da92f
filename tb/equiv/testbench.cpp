#include "tb/equiv/testbench.h"

#include <fmt/core.h>

#include <algorithm>

#include "tb/equiv/clocks.h"

namespace cosim::equiv {
namespace {

std::string range(int width) { return width == 1 ? "" : fmt::format("[{}:0] ", width - 1); }

}  // namespace

std::string stimulus_rows(const Question& q, const Answer& a, bool is_gate) {
  const Side& side = is_gate ? q.gate : q.gold;
  std::string text;
  for (const auto* rows : {&a.clocks, &a.after}) {
    for (const Row& row : *rows) {
      std::string bits;
      for (const auto& [port, value] : row.inputs) {
        if (side.inputs.contains(is_gate ? gate_name(q, port) : port)) bits += value;
      }
      std::replace(bits.begin(), bits.end(), '-', '0');
      text += (bits.empty() ? "0" : bits) + '\n';
    }
  }
  return text;
}

std::string testbench(const Question& q, const Answer& a, bool is_gate, const std::string& rows,
                      const std::string& vcd, std::uint64_t first_drawn) {
  const Side& side = is_gate ? q.gate : q.gold;
  const auto own_name = [&](const std::string& port) {
    return is_gate ? gate_name(q, port) : port;
  };
  // Long beside the delays that RTL may have.
  std::string text = "`timescale 1us/1ps\nmodule cosim_replay;\n", pins, inputs, outputs, formats;
  const auto pin = [&](const std::string& port, const std::string& is) {
    pins += fmt::format("{}.{}({})", pins.empty() ? "" : ", ", port, is);
  };
  for (const auto& [port, width] : side.inputs) {
    if (const auto tied = q.tied.find(port); tied != q.tied.end()) {
      pin(port, fmt::format("{}'b{}", width, tied->second));
    } else if (const auto clock = side.clocks.find(port); clock != side.clocks.end()) {
      pin(port, fmt::format("{}{}", clock->second ? "~" : "",
                            q.steps ? "(cosim_clock & in_" + port + ")" : "cosim_clock"));
    }
  }
  const Row& first = a.clocks.front();
  for (const auto& [port, value] : first.inputs) {
    const std::string own = own_name(port);
    if (!side.inputs.contains(own)) continue;
    text += fmt::format("  reg {}in_{};\n", range(side.inputs.at(own)), own);
    if (!side.clocks.contains(own)) pin(own, "in_" + own);
    inputs += fmt::format("{}in_{}", inputs.empty() ? "" : ", ", own);
  }
  // What an assumption names may be an output that the other one lacks.
  for (const Assumption& one : is_gate ? std::vector<Assumption>{} : q.assumed) {
    for (const std::string& port : one.ports) {
      if (!side.outputs.contains(port) || first.gold.contains(port)) continue;
      const std::string wire =
          fmt::format("  wire {}out_{};\n", range(side.outputs.at(port)), port);
      if (text.find(wire) != std::string::npos) continue;
      text += wire;
      pin(port, "out_" + port);
    }
  }
  for (const auto& [port, value] : first.gold) {
    const std::string own = own_name(port);
    text += fmt::format("  wire {}out_{};\n", range(side.outputs.at(own)), own);
    pin(own, "out_" + own);
    outputs += ", out_" + own;
    formats += " %b";
  }
  std::string modules;
  for (const Assumption& one : is_gate ? std::vector<Assumption>{} : q.assumed) {
    modules += one.verilog;
    text += fmt::format("  wire {0}_holds;\n  {0} {0}_of(.cosim_holds({0}_holds)", one.name);
    for (const std::string& port : one.ports) {
      const auto tied = q.tied.find(port);
      text += fmt::format(", .{}({})", port,
                          tied != q.tied.end()
                              ? fmt::format("{}'b{}", side.inputs.at(port), tied->second)
                          : side.inputs.contains(port) ? "in_" + port
                                                       : "out_" + port);
    }
    text += ");\n";
    outputs += fmt::format(", {}_holds", one.name);
    formats += " %b";
  }
  std::string parameters;
  for (const std::string& one : side.files().parameters) {
    const std::size_t at = one.find('=');
    parameters += fmt::format("{}.{}({})", parameters.empty() ? "" : ", ", one.substr(0, at),
                              one.substr(at + 1));
  }
  if (!parameters.empty()) parameters = "#(" + parameters + ") ";
  const std::size_t clocks = a.clocks.size() + a.after.size();
  std::size_t bits = 0;
  for (const auto& [port, value] : first.inputs) {
    if (side.inputs.contains(own_name(port))) bits += value.size();
  }
  text += fmt::format("  integer cosim_i;\n  reg [{}:0] cosim_rows[0:{}];\n",
                      std::max<std::size_t>(bits, 1) - 1, clocks - 1);
  text += fmt::format("  reg cosim_clock = 0;\n  {} {}cosim_dut({});\n  initial begin\n",
                      side.files().top, parameters, pins);
  text += fmt::format(
      "    $readmemb(\"{}\", cosim_rows);\n    for (cosim_i = 0; cosim_i < {}; cosim_i = cosim_i + "
      "1)"
      " begin\n",
      rows, clocks);
  text += fmt::format(
      "      if (cosim_i == {} && $test$plusargs(\"cosim_wave\")) begin\n        "
      "$dumpfile(\"{}\");\n        $dumpvars;\n      end\n",
      first_drawn, vcd);
  if (!inputs.empty()) text += fmt::format("      {{{}}} = cosim_rows[cosim_i];\n", inputs);
  return modules + text +
         fmt::format(
             "      #1 $display(\"cosim_replay{}\"{});\n      cosim_clock = 1;\n      #1"
             " cosim_clock = 0;\n    end\n    $finish;\n  end\nendmodule\n",
             formats, outputs);
}

}  // namespace cosim::equiv

#include "tb/equiv/testbench.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tb/util/pattern.h"

namespace cosim::equiv {
namespace {

std::string range(int width) { return width == 1 ? "" : fmt::format("[{}:0] ", width - 1); }

// Text with the number of its line.
class Text {
 public:
  void add(const std::string& text) {
    text_ += text;
    line_ += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
  std::size_t line() const { return line_; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t line_ = 1;
};

// An unpacked array, each element of which is joined to its bits.
std::string array_pin(const std::string& array, int width, const std::vector<long>& sizes,
                      const std::string& bits, bool is_input) {
  std::vector<std::string> elements{""};
  std::string dimensions;
  for (const long size : sizes) {
    dimensions += fmt::format("[0:{}]", size - 1);
    std::vector<std::string> inner;
    for (const std::string& one : elements) {
      for (long i = 0; i < size; ++i) inner.push_back(fmt::format("{}[{}]", one, i));
    }
    elements = std::move(inner);
  }
  const int word = width / static_cast<int>(elements.size());
  std::string text = fmt::format("  wire {}{}{};\n", range(word), array, dimensions), whole;
  for (const std::string& one : elements) {
    whole += fmt::format("{}{}{}", whole.empty() ? "" : ", ", array, one);
  }
  return text + (is_input ? fmt::format("  assign {{{}}} = {};\n", whole, bits)
                          : fmt::format("  assign {} = {{{}}};\n", bits, whole));
}

}  // namespace

std::string verilog_name(const std::string& name) { return '\\' + name + ' '; }

std::vector<Variable> variables_of(const Side& side, const std::string& begins) {
  // A path through instances and generated blocks.
  static const Pattern path(R"([A-Za-z_]\w*(\[-?\d+\])*(\.[A-Za-z_]\w*(\[-?\d+\])*)*)");
  std::vector<Variable> all;
  for (const auto& [name, registers] : side.variables) {
    if (path.whole(name).empty()) continue;
    Variable one;
    one.name = name;
    bool is_any = false;
    for (auto at = registers.rbegin(); at != registers.rend(); ++at) {
      const Register& is = side.registers[*at];
      is_any = is_any || is.any;
      one.value += is.any ? (begins.empty() ? 'x' : begins[*at]) : is.first ? '1' : '0';
    }
    one.width = registers.size();
    if (begins.empty() || (!is_any && !side.has_zeros_by_type())) one.value.clear();
    all.push_back(one);
  }
  return all;
}

std::string at_rest(const Side& side, const Stimulus& s) {
  std::string row;
  for (const std::string& port : s.inputs) {
    char is = side.clocks.contains(port) ? '0' : 'x';
    // Verilator has no x: a reset that is active on the first clock has its edge there.
    const auto reset = side.asynchronous_resets.find(port);
    if (reset != side.asynchronous_resets.end()) is = reset->second ? '0' : '1';
    row.append(static_cast<std::size_t>(side.inputs.at(port)), is);
  }
  return row;
}

std::string testbench(const Side& side, const Stimulus& s, const std::string& module,
                      const std::string& folder, std::map<std::size_t, std::string>& line_of) {
  Text text;
  text.add(s.modules);
  // Long beside the delays that RTL may have.
  text.add(fmt::format("`timescale 1us/1ps\nmodule {};\n", module));
  std::string pins, inputs, printed;
  const auto signal = [](const char* begins, const std::string& port) {
    return verilog_name(begins + port);
  };
  const auto connect = [&](const std::string& port, const std::string& is) {
    pins += fmt::format("{}.{}({})", pins.empty() ? "" : ", ", verilog_name(port), is);
  };
  const auto pin = [&](const std::string& port, const std::string& is) {
    const auto array = s.arrays.find(port);
    if (array == s.arrays.end()) return connect(port, is);
    const bool is_input = side.inputs.contains(port);
    const auto whole = signal("array_", port);
    text.add(array_pin(whole, (is_input ? side.inputs : side.outputs).at(port), array->second, is,
                       is_input));
    connect(port, whole);
  };
  std::size_t bits = 0;
  for (const std::string& port : s.inputs) {
    const int width = side.inputs.at(port);
    text.add(fmt::format("  reg {}{};\n", range(width), signal("in_", port)));
    inputs += fmt::format("{}{}", inputs.empty() ? "" : ", ", signal("in_", port));
    bits += static_cast<std::size_t>(width);
    if (!side.clocks.contains(port)) pin(port, signal("in_", port));
  }
  for (const auto& [port, width] : side.inputs) {
    if (const auto tied = s.tied.find(port); tied != s.tied.end()) {
      pin(port, fmt::format("{}'b{}", width, tied->second));
    } else if (const auto clock = side.clocks.find(port); clock != side.clocks.end()) {
      pin(port, fmt::format("{}{}", clock->second ? "~" : "",
                            s.steps ? fmt::format("(cosim_clock & {})", signal("in_", port))
                                    : "cosim_clock"));
    }
  }
  std::vector<std::string> outputs = s.outputs;
  outputs.insert(outputs.end(), s.wires.begin(), s.wires.end());
  for (const std::string& port : outputs) {
    text.add(fmt::format("  wire {}{};\n", range(side.outputs.at(port)), signal("out_", port)));
    pin(port, signal("out_", port));
  }
  for (const std::string& port : s.outputs) printed += ", " + signal("out_", port);
  text.add(s.instances);
  std::string parameters;
  for (const std::string& one : side.files().parameters) {
    const std::size_t at = one.find('=');
    parameters += fmt::format("{}.{}({})", parameters.empty() ? "" : ", ", one.substr(0, at),
                              one.substr(at + 1));
  }
  if (!parameters.empty()) parameters = "#(" + parameters + ") ";
  if (!s.states.empty()) {
    text.add(fmt::format("  reg [{0}:0] cosim_state, cosim_states[0:{1}];\n",
                         s.states.front().size() - 1, s.states.size() - 1));
  }
  text.add(fmt::format(
      "  integer cosim_i, cosim_file;\n  reg [{}:0] cosim_rows[0:{}];\n"
      "  reg cosim_clock = 0;\n  {} {}cosim_dut({});\n  initial begin\n",
      std::max<std::size_t>(bits, 1) - 1, s.rows.size() - 1, side.files().top, parameters, pins));
  if (!s.states.empty()) {
    text.add(fmt::format("    $readmemb(\"{}/states\", cosim_states);\n", folder));
  }
  text.add(
      fmt::format("    cosim_file = $fopen(\"{0}/lines\", \"w\");\n"
                  "    $readmemb(\"{0}/rows\", cosim_rows);\n",
                  folder));
  if (!inputs.empty()) text.add(fmt::format("    {{{}}} = cosim_rows[0];\n", inputs));
  text.add("    #1;\n");
  const auto named = [&](const std::string& name, const std::string& line) {
    line_of[text.line()] = name;
    text.add(line + '\n');
  };
  for (const Contents& one : s.memories) {
    named(one.name,
          fmt::format("    for (cosim_i = {0}; cosim_i < {1}; cosim_i = cosim_i + 1) "
                      "$fdisplay(cosim_file, \"cosim_word {2} %b\", cosim_dut.{2}[cosim_i]);",
                      one.low, one.low + one.words, one.name));
    if (!one.file.empty()) {
      named(one.name, fmt::format("    $readmemb(\"{}\", cosim_dut.{});", one.file, one.name));
    }
  }
  for (const Variable& one : s.variables) {
    named(one.name,
          fmt::format("    $fdisplay(cosim_file, \"cosim_before {0} %b\", cosim_dut.{0});",
                      one.name));
    if (one.value.empty()) continue;
    named(one.name + '=',
          fmt::format("    cosim_dut.{} = {}'b{};", one.name, one.value.size(), one.value));
  }
  text.add("    #1;\n");
  for (const Variable& one : s.variables) {
    named(one.name, fmt::format("    $fdisplay(cosim_file, \"cosim_after {0} %b\", cosim_dut.{0});",
                                one.name));
  }
  text.add(fmt::format("    for (cosim_i = 1; cosim_i < {}; cosim_i = cosim_i + 1) begin\n",
                       s.rows.size()));
  if (!s.vcd.empty()) {
    text.add(
        fmt::format("      if (cosim_i == {}) begin\n        $dumpfile(\"{}\");\n"
                    "        $dumpvars(0, cosim_dut);\n      end\n",
                    s.first_drawn + 1, s.vcd));
  }
  if (!s.states.empty()) {
    text.add(
        fmt::format("      if (cosim_i > {0} && (cosim_i - {1}) % {2} == 0) begin\n"
                    "        cosim_state = cosim_states[(cosim_i - {1}) / {2}];\n",
                    s.first_load, s.first_load + 1, load_clocks));
    for (const Variable& one : s.variables) {
      if (!one.is_loaded) continue;
      const std::size_t high = s.states.front().size() - one.at;
      named(one.name + '@', fmt::format("        cosim_dut.{} = cosim_state[{}:{}];", one.name,
                                        high - 1, high - one.width));
    }
    text.add("      end\n");
  }
  if (!inputs.empty()) text.add(fmt::format("      {{{}}} = cosim_rows[cosim_i];\n", inputs));
  for (const std::string& net : s.further) printed += ", " + net;
  std::string formats;
  for (std::size_t i = 0; i < s.outputs.size() + s.further.size(); ++i) formats += " %b";
  text.add(fmt::format("      #1 $fwrite(cosim_file, \"cosim_replay{}\"{});\n", formats, printed));
  for (const Variable& one : s.variables) {
    named(one.name, fmt::format("      $fwrite(cosim_file, \" %b\", cosim_dut.{});", one.name));
  }
  text.add(
      "      $fwrite(cosim_file, \"\\n\");\n      cosim_clock = 1;\n      #1 cosim_clock = 0;\n    "
      "end\n"
      "    $fdisplay(cosim_file, \"cosim_done\");\n    $finish;\n  end\nendmodule\n");
  return text.text();
}

}  // namespace cosim::equiv

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tb/rtl/regex.h"
#include "tb/rtl/vhdl.h"

namespace cosim::rtl {
namespace {

// Registers that a signal or an output is put together of, by its name and their place in it:
// state_7_4.
void name_parts(const std::string& text, const std::set<std::string>& registers,
                std::set<std::string>& words, std::map<std::string, std::string>& names) {
  static const Regex declared("^  (wire|reg) (\\[([0-9]+):0\\] )?(\\w+);$", REG_NEWLINE),
      joined("^  assign (n[0-9]+_o) = \\{(.*)\\};$", REG_NEWLINE),
      whole("^  assign (\\w+) = (n[0-9]+_o);( // \\(signal\\))?$", REG_NEWLINE),
      constant("^([0-9]+)'b[01xXzZ]+$"), part("[^, ]+");
  std::map<std::string, int> widths;
  for (const Match& m : declared.all(text)) {
    widths[m[4]] = m.has(3) ? std::stoi(m[3]) + 1 : 1;
  }
  std::map<std::string, std::string> owners;  // of a net, the first signal or output
  for (const Match& m : whole.all(text)) owners.try_emplace(m[2], m[1]);
  for (const Match& m : joined.all(text)) {
    const auto owner = owners.find(m[1]);
    if (owner == owners.end()) continue;
    const std::string list = m[2];
    int at = widths[m[1]];
    for (const Match& one : part.all(list)) {
      const std::string net = one[0];
      const Match number = constant.find(net);
      const int width = number ? std::stoi(number[1]) : widths[net];
      if (width == 0) break;
      at -= width;
      const std::string place =
          std::to_string(at + width - 1) + (width > 1 ? '_' + std::to_string(at) : "");
      const std::string name = owner->second + '_' + place;
      if (registers.contains(net) && !names.contains(net) && words.insert(name).second) {
        names[net] = name;
      }
    }
  }
}

}  // namespace

std::string with_names(std::string text) {
  static const Regex initial(
      "^  always @\\*\n    (\\w+) = ([A-Za-z0-9_']+); // \\(isignal\\)\n  initial\n    (\\w+) <= "
      "[^;]*;\n",
      REG_NEWLINE);
  static const Regex is_register("^  reg (\\[[0-9]+:0\\] )?(\\w+);$", REG_NEWLINE);
  static const Regex copy("^  assign (\\w+) = (n[0-9]+_q); // \\(signal\\)\n", REG_NEWLINE);
  static const Regex declared("^  (wire|reg) (\\[[0-9]+:0\\] )?(\\w+);\n", REG_NEWLINE),
      numbered("^n[0-9]+_(\\w+)$"), word("\\w+");
  std::set<std::string> registers, words;
  for (const Match& m : is_register.all(text)) registers.insert(m[2]);
  text = initial.replaced(text, [](const Match& m) {
    return m[1] == m[3] ? "  assign " + m[1] + " = " + m[2] + "; // (signal)\n" : m[0];
  });
  for (const Match& m : word.all(text)) words.insert(m[0]);
  std::map<std::string, std::vector<std::string>> copies;
  for (const Match& m : copy.all(text)) copies[m[2]].push_back(m[1]);
  // A register that has one other name goes by it.
  std::map<std::string, std::string> names;
  std::set<std::string> gone;
  for (const auto& [net, signals] : copies) {
    if (signals.size() > 1 || !registers.contains(net)) continue;
    std::string name = signals[0];
    const Match m = numbered.find(name);
    if (m && words.insert(m[1]).second) name = m[1];
    names[net] = names[signals[0]] = name;
    gone.insert(signals[0]);
  }
  text = copy.replaced(text, [&](const Match& m) { return gone.contains(m[1]) ? "" : m[0]; });
  static const Regex port("^  assign (\\w+) = (n[0-9]+_q);\n", REG_NEWLINE),
      output("\\boutput (\\[[0-9]+:0\\] )?(\\w+)([,)])");
  std::set<std::string> outputs;  // those that are a register
  for (const Match& m : port.all(text)) {
    if (!registers.contains(m[2]) || !names.try_emplace(m[2], m[1]).second) continue;
    outputs.insert(m[1]);
    gone.insert(m[2]);
  }
  text = port.replaced(text, [&](const Match& m) { return outputs.contains(m[1]) ? "" : m[0]; });
  text = output.replaced(text, [&](const Match& m) {
    return outputs.contains(m[2]) ? "output reg " + m[1] + m[2] + m[3] : m[0];
  });
  name_parts(text, registers, words, names);
  text = declared.replaced(text, [&](const Match& m) { return gone.contains(m[3]) ? "" : m[0]; });
  return word.replaced(text, [&](const Match& m) {
    const auto name = names.find(m[0]);
    return name == names.end() ? m[0] : name->second;
  });
}

}  // namespace cosim::rtl

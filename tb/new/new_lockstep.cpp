// The model of every clock that `cosim new` begins for RTL: a struct.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "model/core/input_error.h"
#include "tb/new/new.h"
#include "tb/new/new_members.h"

namespace cosim::cli {
namespace {

// More words of a memory than this take a compiler minutes.
constexpr int most_words = 4096;

constexpr const char* types = "Bit UInt Int Array Unreset At Rises Falls Text clog2 In Out ";
constexpr const char* others =
    "in out clock reset reset_clocks asynchronous_reset reset_at_once rest cases legal idle "
    "invariant reached compared unobserved source register_suffix Job Work Driver Checker View "
    "job_of checker_of smaller describe most_clocks Auxiliary Hex Fraction "
    "Source Sampled Range OnesComplement OnesComplementCode Stated stated active_low active_high "
    "both zero cat mux "
    "merge reduce_and reduce_or reduce_xor";

std::string parameter(const std::string& name) {
  return TakenNames(std::string(types) + others).other_than(name);
}

std::string struct_text(const std::string& name, const std::vector<Member>& members) {
  if (members.empty()) return fmt::format("  struct {} {{}};\n", name);
  return fmt::format("  struct {} {{\n{}  }};\n", name, declared(members, "    "));
}

std::string name_of(const std::vector<Member>& members, const std::string& net) {
  const auto m =
      std::ranges::find_if(members, [&](const Member& one) { return one.net.name == net; });
  return m == members.end() ? "" : m->name;
}

// What is said of the resets.
std::string reset_of(const Found& f, const std::vector<Member>& inputs) {
  std::string high, low;
  for (const FoundReset& r : f.resets) {
    if (r.is_inner) continue;
    std::string& pins = r.active_low ? low : high;
    pins += fmt::format("{}&In::{}", pins.empty() ? "" : ", ", name_of(inputs, r.name));
  }
  if (!high.empty()) high = fmt::format("active_high<{}>", high);
  if (!low.empty()) low = fmt::format("active_low<{}>", low);
  const bool is_both = !high.empty() && !low.empty();
  if (high.empty() && low.empty()) return "";
  return fmt::format("  static constexpr auto reset = {};\n",
                     is_both ? fmt::format("both({}, {})", high, low) : high + low);
}
bool has_reset_at_once(const Found& f) {
  return f.asynchronous && (f.resets.size() > 1 || f.has_inner_reset());
}
std::string reset_at_once_of(const Found& f, const std::vector<Member>& inputs,
                             const std::vector<Member>& registers) {
  std::string text =
      "\n  /// What each reset does that does not wait for a clock.\n"
      "  void reset_at_once(const In& in) {\n";
  for (const FoundReset& r : f.resets) {
    std::string values;
    for (const auto& [name, value] : r.values) {
      for (const Member& m : registers) {
        if (m.net.name != name) continue;
        values += fmt::format("      {} = {};\n", m.name, value_of(value, m));
      }
    }
    if (values.empty()) continue;
    const std::string pin =
        r.is_inner ? name_of(registers, r.name) : "in." + name_of(inputs, r.name);
    text += fmt::format("    if ({}{}) {{\n{}    }}\n", r.active_low ? "!" : "", pin, values);
  }
  return text + "  }\n";
}

// A comment, in lines of a usual length.
std::string comment_of(const std::vector<std::string>& words, const std::string& indent) {
  constexpr std::size_t longest = 98;
  std::string text, line = indent + "//";
  for (const std::string& word : words) {
    if (line.size() + word.size() > longest) {
      text += line + '\n';
      line = indent + "//";
    }
    line += ' ' + word;
  }
  return text + line + '\n';
}

// What a clock of the one clock, or of each of several, is to do.
std::string edges_of(const Found& f, const std::vector<Member>& inputs,
                     const std::vector<Member>& registers, const std::string& title) {
  std::string text;
  for (const FoundClock& clock : f.clocks) {
    if (!f.clocks_are_inputs()) break;
    std::vector<std::string> words;
    for (const Member& m : registers) {
      const auto& of = m.net.clocks;
      if (f.clocks.size() > 1 && std::ranges::find(of, clock.name) == of.end()) continue;
      words.push_back(m.name + ',');
    }
    if (!words.empty()) words.back().pop_back();
    text += fmt::format("    if (in.{}) {{\n{}    }}\n", name_of(inputs, clock.name),
                        words.empty() ? "" : comment_of(words, "      "));
  }
  if (f.clocks_are_inputs() || f.resets.size() != 1 || f.asynchronous) return text;
  const FoundReset& r = f.resets.front();
  const bool all = std::ranges::all_of(registers, [](const auto& m) { return m.net.is_reset; });
  std::string values;
  for (const Member& m : registers) {
    if (m.net.is_reset) values += fmt::format("      {} = {};\n", m.name, m.value);
  }
  return fmt::format("    if ({}in.{}) {{\n{}    }} else {{\n    }}\n", r.active_low ? "!" : "",
                     name_of(inputs, r.name),
                     all ? fmt::format("      *this = {}{{}};\n", title) : values);
}

std::string clock_of(const Found& f, const std::vector<Member>& inputs,
                     const std::vector<Member>& outputs, const std::vector<Member>& registers,
                     const std::string& title) {
  const std::string edges = edges_of(f, inputs, registers, title);
  std::string text =
      fmt::format("\n  Out clock({}const In& in){} {{\n", edges.empty() ? "[[maybe_unused]] " : "",
                  f.clocks.empty() ? " const" : "");
  const std::vector<std::string> zeros = zeros_of(outputs);
  const std::string one_line = fmt::format("    const Out out{{{}}};\n", fmt::join(zeros, ", "));
  text += f.clocks.empty()
              ? "    // To be written: the outputs.\n"
              : "    // To be written: the outputs, from the registers before the edge; "
                "then the registers after it.\n";
  if (f.clocks.size() > 1)
    text +=
        "    // Each clock takes the registers of the others as they "
        "are before it.\n";
  text += one_line.size() <= 100 ? one_line
                                 : fmt::format("    const Out out{{\n        {},\n    }};\n",
                                               fmt::join(zeros, ",\n        "));
  return text + edges + "    return out;\n  }\n";
}

void require_few(const std::vector<Member>& members, const std::string& of, const char* what) {
  const std::size_t count = zeros_of(members).size();
  if (count <= most_members) return;
  throw InputError(
      fmt::format("new: {}: {} {}: a model has at most {}", of, count, what, most_members));
}

}  // namespace

std::string type_of(const FoundNet& net) {
  if (net.edge != Edge::none) return net.edge == Edge::rising ? "Rises" : "Falls";
  const bool is_split = net.words.number != 0 && part_of(net) != net.width.number;
  const FoundSize width = is_split ? FoundSize{part_of(net)} : net.width;
  std::string type = width.number == 1 && width.text.empty()
                         ? "Bit"
                         : fmt::format("{}Int<{}>", net.is_signed ? "" : "U", text_of(width));
  if (net.words.number == 0) return type;
  const int each = is_split ? net.width.number / width.number : 1;
  const std::string words = is_split ? std::to_string(net.words.number * each) : text_of(net.words);
  return fmt::format("Array<{}, {}>", type, words);
}

std::string text_of(const FoundSize& size) { return text_of(size, parameter); }

std::string template_of(const Found& found) {
  std::vector<std::string> all;
  for (const FoundParameter& p : found.parameters) {
    all.push_back((p.is_text ? "Text " : "int ") + parameter(p.name));
  }
  return all.empty() ? "" : fmt::format("template <{}>\n", fmt::join(all, ", "));
}

std::string taken_in(const std::string& title, const Found& found) {
  std::string taken = types + title;
  for (const FoundParameter& p : found.parameters) taken += ' ' + parameter(p.name);
  return taken;
}

std::string struct_of(const std::string& name, const Found& found) {
  TakenNames taken(std::string(types) + others + " Stream Pin");
  for (const FoundParameter& p : found.parameters) taken.insert(p.name);
  const std::string word = in_one_word(name);
  return taken.contains(word) ? word + "Model" : word;
}

BegunModel lockstep_model(const std::string& name, const Found& f) {
  BegunModel model{"", {"clock() is to be written"}};
  std::vector<FoundNet> nets;
  std::vector<std::string> unobserved;
  for (const FoundNet& net : f.registers) {
    if (net.words.number >= 0 && net.words.number <= most_words) {
      nets.push_back(net);
      continue;
    }
    unobserved.push_back('"' + net.name + '"');
    model.left.push_back(
        fmt::format("{} is not compared: {}", net.name,
                    net.words.number < 0 ? "it is a queue or the like" : "it has too many words"));
  }
  if (f.resets.empty() && !f.clocks.empty()) {
    model.left.push_back(
        "no reset is found: it begins at its initial values; --reset PIN names one");
  }
  const std::string title = struct_of(name, f);
  const std::string taken = taken_in(title, f);
  const auto inputs = input_members(f.inputs, taken);
  const EnumTypes enums(title, f.enums);
  const auto outputs = output_members(f.outputs, taken, enums);
  const auto registers = register_members(nets, taken + ' ' + others, enums);
  require_few(inputs, f.top, "inputs");
  require_few(outputs, f.top, "outputs");
  require_few(registers, f.top, "registers");

  std::string& text = model.text;
  text = fmt::format(
      "// Golden model of {}: what every register and output is, clock by clock.\n"
      "#pragma once\n\n"
      "#include <cosim/model.h>\n",
      f.top);
  if (std::max({inputs.size(), outputs.size(), registers.size()}) > 64) {
    text += "#include <cosim/many_members.h>\n";
  }
  if (!f.enums.empty()) text += "#include <cosim/enum.h>\n";
  text += '\n' + enums.text();
  text += template_of(f);
  text += fmt::format("struct {} {{\n", title) + struct_text("In", inputs) +
          struct_text("Out", outputs) + reset_of(f, inputs);
  if (f.asynchronous && !has_reset_at_once(f)) {
    text += "  static constexpr bool asynchronous_reset = true;\n";
  }
  if (!unobserved.empty()) {
    text += fmt::format("  static constexpr std::array unobserved{{{}}};\n",
                        fmt::join(unobserved, ", "));
  }
  if (!registers.empty()) text += '\n';
  text += declared(registers, "  ");
  text += clock_of(f, inputs, outputs, registers, title);
  if (has_reset_at_once(f)) text += reset_at_once_of(f, inputs, registers);
  text += "};\n";
  return model;
}

}  // namespace cosim::cli

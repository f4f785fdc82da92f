// The model of every clock that `cosim new` begins for RTL.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "tb/new/new.h"

namespace cosim::cli {
namespace {

// A table of more cells than this takes a compiler minutes.
constexpr int most_cells = 4096;

// Names of fields that differ: the second of two alike ends in _2.
class Names {
 public:
  std::string of(const std::string& path) {
    const std::string name = field_of(path);
    std::string another = name;
    for (int i = 2; !taken_.insert(another).second; ++i) another = fmt::format("{}_{}", name, i);
    return another;
  }

 private:
  std::set<std::string> taken_;
};

std::vector<NewRow> rows_of(const std::vector<FoundNet>& nets) {
  std::vector<NewRow> rows;
  Names names;
  for (const FoundNet& net : nets) {
    if (net.bits.empty() || net.words.number != 0) {
      const std::string field = names.of(net.name);
      rows.push_back({field, net, field != net.name});
      continue;
    }
    for (const auto& [high, low] : net.bits) {
      FoundNet part = net;
      part.width = {high - low + 1};
      part.value.clear();
      const std::string bits =
          high == low ? fmt::format("[{}]", low) : fmt::format("[{}:{}]", high, low);
      rows.push_back({names.of(fmt::format("{}_{}_{}", net.name, high, low)), part, true, bits});
    }
  }
  return rows;
}

bool is_in_table(const FoundNet& net) {
  return net.words.number >= 0 && net.words.number * ((net.width.number + 63) / 64) <= most_cells;
}

// The head of a model's step, up to its body.
std::string step_head(bool plain) {
  return fmt::format(
      "{0} Step<{1}> next([[maybe_unused]] const Params& p, const State<{1}>& s,\n"
      "                       [[maybe_unused]] const Inputs<{1}>& in) {{\n",
      plain ? "inline" : "template <class V>\nconstexpr", plain ? "Word" : "V");
}

std::string reset_inputs_of(const Found& f) {
  std::string rest, reset;
  for (const FoundReset& r : f.resets) {
    if (r.is_inner) continue;
    if (r.active_low) rest += fmt::format("{}.{} = 1", rest.empty() ? "" : ", ", field_of(r.name));
    reset += fmt::format("{}.{} = {}", reset.empty() ? "" : ", ", field_of(r.name),
                         r.active_low ? 0 : 1);
  }
  if (reset.empty()) return "";
  std::string text;
  if (!rest.empty()) {
    text += fmt::format(
        "  /// A clock on which nothing is asked, and one that resets every register.\n"
        "  static constexpr Inputs<Word> rest() {{ return {{{}}}; }}\n",
        rest);
  } else {
    text += "  /// a clock that resets every register.\n";
  }
  text +=
      fmt::format("  static constexpr Inputs<Word> reset_inputs() {{ return {{{}}}; }}\n", reset);
  if (f.asynchronous && f.resets.size() == 1) {
    text += "  static constexpr bool asynchronous_reset = true;\n";
  }
  return text;
}

// "V(7)", for a field of at most 63 bits.
std::string constant(const std::string& hex) { return hex == "0" ? "V(0)" : "V(0x" + hex + ")"; }
bool is_word(const NewRow& row) {
  return row.net.words.number == 0 && row.net.width.number < 64 && row.bits.empty();
}

// What the registers hold after a reset, where it is not 0.
std::string reset_state_of(const std::vector<NewRow>& rows) {
  std::string values;
  for (const NewRow& row : rows) {
    if (row.net.value.empty() || !is_word(row)) continue;
    values += fmt::format("    s.{} = {};\n", row.field, constant(row.net.value));
  }
  if (values.empty()) return "";
  return "  template <class V>\n  static constexpr State<V> reset_state() {\n    State<V> s;\n" +
         values + "    return s;\n  }\n";
}

// A comment of some words, in lines of a usual length.
std::string comment_of(const std::vector<std::string>& words) {
  constexpr std::size_t longest = 92;
  std::string text, line = "  //";
  for (const std::string& word : words) {
    if (line.size() + word.size() > longest) {
      text += line + '\n';
      line = "  //";
    }
    line += ' ' + word;
  }
  return text + line + '\n';
}

// What is to be written in a step. Of several clocks each has its part.
std::string step_of(const Found& f, const std::vector<NewRow>& rows, bool plain) {
  if (!f.clocks_are_inputs()) {
    return "  // To be written: step.outputs of this clock, step.state after it.\n";
  }
  std::string text =
      "  // To be written: step.outputs of this step, and of each clock what its edge makes of "
      "s.\n";
  for (const FoundClock& clock : f.clocks) {
    std::vector<std::string> words{clock.name, clock.edge == Edge::rising ? "rises:" : "falls:"};
    for (const NewRow& row : rows) {
      const auto& of = row.net.clocks;
      if (f.clocks.size() > 1 && std::ranges::find(of, clock.name) == of.end()) continue;
      words.push_back(row.field + ',');
    }
    words.back().back() = words.size() == 2 ? ':' : '.';
    text += '\n' + comment_of(words);
    const std::string pin = field_of(clock.name);
    text += plain ? fmt::format("  if (in.{} != 0) {{\n  }}\n", pin)
                  : fmt::format(
                        "  State<V> on_{0} = step.state;\n"
                        "  step.state = select(is_set(in.{0}), on_{0}, step.state);\n",
                        pin);
  }
  return text;
}

// The state under each of several resets.
std::string reset_of(const Found& f, const std::vector<NewRow>& rows, bool plain) {
  if (!f.asynchronous || (f.resets.size() < 2 && !f.has_inner_reset())) return "";
  const std::string type = plain ? "Word" : "V";
  std::string text = fmt::format(
      "/// Under the resets that do not wait for the clock.\n"
      "{0} State<{1}> reset(const Params&, State<{1}> s, const Inputs<{1}>& in) {{\n",
      plain ? "inline" : "template <class V>\nconstexpr", type);
  for (const FoundReset& r : f.resets) {
    const std::string pin = (r.is_inner ? "s." : "in.") + field_of(r.name);
    const std::string on = plain ? fmt::format("({} {} 0)", pin, r.active_low ? "==" : "!=")
                                 : fmt::format("{}is_set({})", r.active_low ? "!" : "", pin);
    for (const auto& [name, value] : r.values) {
      const auto row = std::ranges::find_if(
          rows, [&n = name](const NewRow& q) { return q.net.name == n && q.bits.empty(); });
      if (row == rows.end()) continue;
      const std::string is = plain ? "0x" + value : constant(value);
      if (is_word(*row)) {
        text += plain ? fmt::format("  if {} s.{} = {};\n", on, row->field, is)
                      : fmt::format("  s.{0} = select({1}, {2}, s.{0});\n", row->field, on, is);
      } else if (value == "0") {
        text += plain
                    ? fmt::format("  if {} s.{} = {{}};\n", on, row->field)
                    : fmt::format("  for (V& v : s.{}) v = select({}, V(0), v);\n", row->field, on);
      }
    }
  }
  return text + "  return s;\n}\n\n";
}

}  // namespace

BegunModel lockstep_model(const std::string& name, const Found& f, bool plain) {
  const std::string table = upper(name);
  BegunModel model;
  std::vector<FoundNet> in_table;
  std::vector<std::string> unobserved;
  for (const FoundNet& net : f.registers) {
    if (is_in_table(net)) {
      in_table.push_back(net);
    } else {
      unobserved.push_back('"' + net.name + '"');
      model.left.push_back(fmt::format(
          "{} is not compared: {}", net.name,
          net.words.number < 0 ? "it has more dimensions than one" : "it has too many words"));
    }
  }
  const std::vector<NewRow> rows = rows_of(in_table);
  model.left.insert(model.left.begin(), "next() is to be written");
  if (f.resets.empty() && !f.clocks.empty()) {
    model.left.push_back(
        "no reset is found: it begins at its initial values; --reset PIN names one");
  }
  std::string more;
  if (!unobserved.empty()) {
    more = fmt::format("  static constexpr std::array unobserved{{{}}};\n",
                       fmt::join(unobserved, ", "));
  }
  model.text = fmt::format(
      "// Golden model of {0}: what every register and output is, clock by clock.\n"
      "#pragma once\n\n"
      "#include <array>\n\n"
      "#include \"model/core/design.h\"\n\n"
      "namespace {0}_model {{\n\n"
      "using namespace cosim;\n\n"
      "{1}\n"
      "// FIELD(name, width, format, its number in a printed source, meaning)\n"
      "{2}{3}{4}"
      "COSIM_RECORDS({5}, Params);\n\n"
      "{8}"
      "  Step<{9}> step{{s, {{}}}};\n"
      "{11}"
      "  return step;\n"
      "}}\n\n"
      "{10}"
      "struct Design {{\n"
      "  COSIM_DESIGN({0}_model);\n"
      "  static constexpr const char* name = \"{0}\";\n"
      "{6}{7}"
      "}};\n\n"
      "}}  // namespace {0}_model\n",
      name, params_of(f), table_of(table + "_INPUTS", rows_of(f.inputs)),
      table_of(table + "_OUTPUTS", rows_of(f.outputs)), table_of(table + "_STATE", rows), table,
      reset_inputs_of(f) + reset_state_of(rows) + more, parameters_of(f), step_head(plain),
      plain ? "Word" : "V", reset_of(f, rows, plain), step_of(f, rows, plain));
  return model;
}

}  // namespace cosim::cli

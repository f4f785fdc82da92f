// The model of every clock that `cosim new` begins for RTL.
#include <fmt/core.h>

#include "tb/cli/new.h"

namespace cosim::cli {
namespace {

std::vector<NewRow> rows_of(const std::vector<FoundNet>& nets) {
  std::vector<NewRow> rows;
  for (const FoundNet& net : nets) {
    const std::string field = field_of(net.name);
    rows.push_back({field, net, field != net.name});
  }
  return rows;
}

// The head of a model's step, up to its body.
std::string step_head(bool plain) {
  return fmt::format(
      "{0} Step<{1}> next([[maybe_unused]] const Params& p, const State<{1}>& s,\n"
      "                       [[maybe_unused]] const Inputs<{1}>& in) {{\n",
      plain ? "inline" : "template <class V>\nconstexpr", plain ? "Word" : "V");
}

std::string clear_of(const Found& f) {
  std::string clear;
  if (!f.reset.empty() && f.active_low) {
    clear = fmt::format(
        "  /// A clock on which nothing is asked, and one that clears every register.\n"
        "  static constexpr Inputs<Word> rest() {{ return {{.{0} = 1}}; }}\n"
        "  static constexpr Inputs<Word> clear() {{ return {{.{0} = 0}}; }}\n",
        field_of(f.reset));
  } else {
    clear = fmt::format(
        "  /// A clock that clears every register.\n"
        "  static constexpr Inputs<Word> clear() {{ return {{{}}}; }}\n",
        f.reset.empty() ? "/* the reset, such as .rst = 1 */" : "." + field_of(f.reset) + " = 1");
  }
  if (f.asynchronous) clear += "  static constexpr bool asynchronous_reset = true;\n";
  return clear;
}

}  // namespace

BegunModel lockstep_model(const std::string& name, const Found& f, bool plain) {
  const std::string table = upper(name);
  BegunModel model;
  model.left.push_back("next() is to be written");
  if (f.reset.empty()) model.left.push_back("clear() is to name the reset");
  model.text = fmt::format(
      "// Golden model of {0}: what every register and output is, clock by clock.\n"
      "#pragma once\n\n"
      "#include <array>\n\n"
      "#include \"model/core/design.h\"\n\n"
      "namespace cosim::{0} {{\n\n"
      "{1}\n"
      "// FIELD(name, width, format, its number in a printed source, meaning)\n"
      "{2}{3}{4}"
      "COSIM_RECORDS({5}, Params);\n\n"
      "{8}"
      "  Step<{9}> step{{s, {{}}}};\n"
      "  // To be written: step.outputs of this clock, step.state after it.\n"
      "  return step;\n"
      "}}\n\n"
      "struct Design {{\n"
      "  COSIM_DESIGN({0});\n"
      "  static constexpr const char* name = \"{0}\";\n"
      "{6}{7}"
      "}};\n\n"
      "}}  // namespace cosim::{0}\n",
      name, params_of(f), table_of(table + "_INPUTS", rows_of(f.inputs)),
      table_of(table + "_OUTPUTS", rows_of(f.outputs)),
      table_of(table + "_STATE", rows_of(f.registers)), table, clear_of(f), parameters_of(f),
      step_head(plain), plain ? "Word" : "V");
  return model;
}

}  // namespace cosim::cli

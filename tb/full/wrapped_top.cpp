#include "tb/full/wrapped_top.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>

#include "model/core/input_error.h"
#include "tb/cli/named_values.h"
#include "tb/new/verilog_words.h"
#include "tb/new/wrapper.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/rtl/regex.h"
#include "tb/util/output_file.h"
#include "tb/util/pattern.h"
#include "tb/util/scratch.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

// What --param gives: the parameters of a shape, and those that are given by a wrapper.
struct GivenParameters {
  std::vector<FoundParameter> shape;
  std::map<std::string, std::string> code;                                  // SystemVerilog
  std::map<std::string, std::map<std::string, std::string>> of_interfaces;  // by ports
};
GivenParameters parameters_in(const std::vector<std::string>& words,
                              const std::optional<TopHead>& head) {
  static const Pattern parameter("([A-Za-z_][A-Za-z0-9_$]*)=(.+)"), number("-?[0-9]{1,9}"),
      constant("[0-9]*'[sS]?[bodhBODH][0-9a-fA-F_]+"), text("[A-Za-z0-9_.:+-]+"),
      of_package("[A-Za-z_][A-Za-z0-9_$]*::.*"),
      of_interface("([A-Za-z_][A-Za-z0-9_$]*)[.]([A-Za-z_][A-Za-z0-9_$]*)=(.+)");
  GivenParameters all;
  for (const std::string& word : words) {
    if (const auto own = of_interface.whole(word); !own.empty()) {
      all.of_interfaces[own[1]][own[2]] = own[3];
      continue;
    }
    const auto parts = parameter.whole(word);
    const bool is_number = !parts.empty() && !number.whole(parts[2]).empty();
    if (!is_number && !parts.empty() && !constant.whole(parts[2]).empty()) {
      throw InputError(fmt::format(
          "--param: {}: the value must be a whole number or a word, not a constant with a base",
          in_quotes(word)));
    }
    if (parts.empty()) {
      throw InputError(fmt::format("--param: {} is not NAME=VALUE", in_quotes(word)));
    }
    const bool is_code = text.whole(parts[2]).empty() || !of_package.whole(parts[2]).empty() ||
                         (head && head->is_type(parts[1]));
    if (!is_number && is_code) {
      all.code[parts[1]] = parts[2];
    } else {
      all.shape.push_back({parts[1], parts[2], !is_number});
    }
  }
  named_values("--param", words);
  return all;
}

// Interfaces, and what may stand before them: packages, and macros.
std::vector<std::string> files_of_interfaces(const Sources& rtl) {
  std::vector<std::string> all;
  for (const SourceFile& file : rtl.files) {
    if (rtl::is_vhdl(file.from)) continue;
    const auto units = verilog_words(file.text).units;
    const bool has_module_alone =
        units.size() > 1 && std::all_of(units.begin() + 1, units.end(),
                                        [](const VerilogUnit& u) { return u.is_module; });
    if (!has_module_alone) all.push_back(file.name);
  }
  return all;
}

// What the wrapper has of the interfaces among the top's ports.
std::vector<OpenedPort> opened_in(const TopHead& head, const GivenParameters& given,
                                  const Sources& rtl, const RtlQuestion& asked) {
  std::vector<InterfacePort> ports = head.interfaces();
  for (const auto& [name, values] : given.of_interfaces) {
    const auto port = std::ranges::find(ports, name, &InterfacePort::name);
    if (port == ports.end()) {
      throw InputError(fmt::format("--param: {} has no interface {} as a port", rtl.top, name));
    }
    port->values = values;
  }
  if (ports.empty()) return {};
  const Scratch scratch;
  RtlQuestion question;
  question.folder = asked.folder;
  question.options = asked.options;
  question.top = rtl.top + "_interfaces";
  question.files = files_of_interfaces(rtl);
  question.files.push_back((scratch.path() / "interfaces.sv").string());
  write_file(question.files.back(), probe_of(question.top, ports));
  const rtl::Tree tree = [&] {
    try {
      return rtl::Tree(tree_in(question, scratch.path() / "work"));
    } catch (const InputError& error) {
      static const Pattern lacks_file("no file has the module ([^:]+):"),
          lacks_value("the parameter ([A-Za-z0-9_$]+) has no value of its own");
      if (const auto name = lacks_file.all(error.what()); !name.empty()) {
        throw InputError(
            fmt::format("no file has the interface {}: give its file, too", name[0][1]));
      }
      const auto found = lacks_value.all(error.what());
      if (found.empty()) throw;
      throw InputError(fmt::format(
          "the parameter {} of an interface has no value of its own: give it one: --param "
          "PORT.{}=VALUE",
          found[0][1], found[0][1]));
    }
  }();
  std::vector<OpenedPort> all;
  for (const InterfacePort& port : ports) all.push_back(opened(port, tree, head.pins()));
  return all;
}

std::optional<TopHead> head_in(const Sources& rtl) {
  std::optional<TopHead> head;
  for (const SourceFile& file : rtl.files) {
    const auto units = verilog_words(file.text).units;
    const bool has_top = std::ranges::any_of(
        units, [&](const VerilogUnit& unit) { return unit.is_module && unit.name == rtl.top; });
    if (has_top && !rtl::is_vhdl(file.from)) head.emplace(file.text, rtl.top);
  }
  return head;
}

// InputError for a word that is given to a parameter which is a number in the text of its file.
void require_texts(const std::vector<FoundParameter>& given, const Sources& rtl) {
  for (const FoundParameter& one : given) {
    if (!one.is_text) continue;
    const std::string named = R"((^|[^A-Za-z0-9_.$]))" + one.name + R"([ \t\r\n]*=[ \t\r\n]*)";
    const rtl::Regex number(named + "(-?[0-9][0-9a-zA-Z_']*)"), text(named + "\"");
    for (const SourceFile& file : rtl.files) {
      if (rtl::is_vhdl(file.from)) continue;
      const std::string blank = rtl::blanked(file.text);
      const rtl::Match is = number.find(blank);
      if (!is || text.find(file.text)) continue;
      throw InputError(fmt::format("--param: {0}: {1} is no number, as {0} = {2} in {3} is",
                                   one.name, in_quotes(one.value), is[2], file.name));
    }
  }
}

}  // namespace

bool needs_wrapper(const std::vector<std::string>& words, const Sources& rtl) {
  const std::optional<TopHead> head = head_in(rtl);
  if (!head) return false;
  return !head->interfaces().empty() || std::ranges::any_of(words, [&](const std::string& word) {
    return head->is_type(word.substr(0, word.find('=')));
  });
}

std::vector<FoundParameter> with_wrapper(const std::string& name,
                                         const std::vector<std::string>& words, Sources& rtl,
                                         const RtlQuestion& asked) {
  const std::optional<TopHead> head = head_in(rtl);
  const GivenParameters given = parameters_in(words, head);
  if (!head && !given.of_interfaces.empty()) {
    throw InputError(fmt::format("--param: {}: {} has no interface as a port",
                                 given.of_interfaces.begin()->first, rtl.top));
  }
  if (!head && !given.code.empty()) {
    throw InputError(
        fmt::format("--param: {}={}: a type or an expression needs a top in Verilog, and {} is not",
                    given.code.begin()->first, given.code.begin()->second, rtl.top));
  }
  require_texts(given.shape, rtl);
  if (!head) return given.shape;
  const std::vector<OpenedPort> opened = opened_in(*head, given, rtl, asked);
  if (given.code.empty() && opened.empty()) return given.shape;
  std::string top = name + "_top";
  while (top == rtl.top) top += "_";
  rtl.files.push_back({top + ".sv", top + ".sv", head->wrapped(top, given.code, opened)});
  rtl.top = top;
  return given.shape;
}

}  // namespace cosim::cli

// Expressions on ports that are wider: Verilog works them out in as many bits as the port has,
// yosys and Icarus Verilog in their own, without the carry.
#include <fmt/core.h>

#include <cctype>
#include <map>
#include <optional>

#include "tb/equiv/misread.h"
#include "tb/equiv/prints.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"
#include "tb/util/pattern.h"

namespace cosim::equiv {
namespace {

bool is_of_a_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}

using Macros = std::map<std::string, std::string>;

// What stands for each macro, behind its arguments if it has some.
Macros macros_in(const std::vector<SourceText>& sources) {
  static const rtl::Regex define(
      "`define[ \t]+([A-Za-z_][A-Za-z0-9_$]*)(\\([^)]*\\))?(([^\\\n]|\\\\.|\\\\\n)*)");
  Macros macros;
  for (const SourceText& source : sources) {
    for (const rtl::Match& one : define.all(source.text)) macros[one[1]] += one[3];
  }
  return macros;
}

// Whether more bits than its own may matter to an expression; what stands in an index, in braces or
// in the arguments of a function has its own ones. So they may to a macro of which nothing is
// known.
bool grows(std::string_view expression, const Macros& macros, int levels = 0) {
  int depth = 0;
  bool is_name = false;  // before this place
  for (std::size_t i = 0; i < expression.size(); ++i) {
    const char c = expression[i];
    const bool opens = c == '[' || c == '{' || (c == '(' && (depth > 0 || is_name));
    const bool closes = c == ']' || c == '}' || (c == ')' && depth > 0);
    depth += opens ? 1 : closes ? -1 : 0;
    const bool is_shift = expression.substr(i, 2) == "<<";
    if (depth == 0 && (is_shift || std::string_view("+-*/%~").find(c) != std::string_view::npos)) {
      return true;
    }
    if (c == '`') {
      std::size_t end = i + 1;
      while (end < expression.size() && is_of_a_name(expression[end])) ++end;
      const auto macro = macros.find(std::string(expression.substr(i + 1, end - i - 1)));
      constexpr int most = 20;
      if (macro == macros.end() || levels == most || grows(macro->second, macros, levels + 1)) {
        return true;
      }
    }
    if (std::isspace(static_cast<unsigned char>(c)) == 0) {
      is_name = is_of_a_name(c);
    }
  }
  return false;
}

// Where an instance of this name connects an expression that grows to a port: by its name, or to
// one of those that are in order. npos where it does not; nothing where there is no such instance.
std::optional<std::size_t> growing(const std::string& plain, const std::string& instance,
                                   const std::string& port, const Macros& macros) {
  const rtl::Regex begin("\\b" + instance + "\\s*(\\[[^]]*\\]\\s*)?\\("),
      named("\\." + port + "\\s*\\("), by_name("^[^(]*\\(\\s*\\.");
  std::optional<std::size_t> found_at;
  for (const rtl::Match& found : begin.all(plain)) {
    found_at = std::string::npos;
    const std::size_t open = found.end() - 1;
    const std::string all = plain.substr(open, behind_arguments(plain, open) - open);
    if (!by_name.find(all)) {
      if (grows(std::string_view(all).substr(1, all.size() - 2), macros)) return found.begin();
      continue;
    }
    const rtl::Match at = named.find(all);
    if (!at) continue;
    const std::size_t from = at.end(), to = behind_arguments(all, from - 1);
    if (grows(std::string_view(all).substr(from, to - from - 1), macros)) return open + at.begin();
  }
  return found_at;
}

// The same in all files: the place, or that it is none that can be told from the text.
struct Growing {
  bool is_so = false;
  std::string place;  ///< "FILE:LINE: " or nothing
};
Growing growing(const std::vector<SourceText>& sources, const std::string& instance,
                const std::string& port) {
  static const rtl::Regex plain_name("^[A-Za-z_][A-Za-z0-9_$]*$"), dollar("[$]");
  bool is_seen = false;
  if (plain_name.find(instance) && plain_name.find(port)) {
    const Macros macros = macros_in(sources);
    for (const SourceText& source : sources) {
      const auto at = growing(rtl::blanked(source.text), dollar.replaced(instance, "[$]"),
                              dollar.replaced(port, "[$]"), macros);
      if (at && *at != std::string::npos) return {true, place_in(source, *at) + ": "};
      is_seen = is_seen || at;
    }
  }
  // In a macro, or by an escaped name: what is connected is not known.
  return {!is_seen, ""};
}

}  // namespace

std::string cut_on_a_port(const std::string& said, const std::vector<SourceText>& sources) {
  static const Pattern resized(
      R"(Resizing cell port (?:(\S*)\.)?([^\s.]+?)(?:\[\d+\])?\.([^\s.]+) from (\d+) bits to (\d+) bits)");
  for (const Pattern::Parts& part : resized.all(said)) {
    if (std::stoul(part[4]) >= std::stoul(part[5])) continue;
    const Growing is = growing(sources, part[2], part[3]);
    if (!is.is_so) continue;
    return fmt::format(
        "{}port {} of {} has {} bits, and the expression that it is given is read "
        "with {}: give it a wire of {} bits",
        is.place, part[3], part[2], part[5], part[4], part[5]);
  }
  return "";
}

bool may_be_cut_on_ports(const std::vector<SourceText>& sources) {
  // By its name, or in order.
  static const rtl::Regex named("\\.(\\\\[^[:space:]]+|[A-Za-z0-9_$]+)\\s*\\("),
      ordered(
          "\\b([A-Za-z_]\\w*)\\s+(#\\s*\\([^;]*\\)\\s*)?([A-Za-z_]\\w*)\\s*\\(\\s*[^.[:space:]]"),
      keyword(
          "^(else|begin|end|assign|return|always.*|initial|module|function|task|automatic|if|for|"
          "foreach|while|repeat|wait|case[xz]?|unique|priority|assert|assume|cover|or|and|not)$");
  const Macros macros = macros_in(sources);
  for (const SourceText& source : sources) {
    const std::string plain = rtl::blanked(source.text);
    const auto is_cut = [&](std::size_t open) {
      const std::size_t end = behind_arguments(plain, open);
      return grows(std::string_view(plain).substr(open + 1, end - open - 2), macros);
    };
    for (const rtl::Match& found : named.all(plain)) {
      if (is_cut(found.end() - 1)) return true;
    }
    for (const rtl::Match& found : ordered.all(plain)) {
      if (keyword.find(found[1]) || keyword.find(found[3])) continue;
      if (is_cut(plain.rfind('(', found.end() - 1))) return true;
    }
  }
  return false;
}

}  // namespace cosim::equiv

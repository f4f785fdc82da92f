// Expressions on ports that are wider: Verilog works them out in as many bits as the port has,
// yosys and Icarus Verilog in their own, without the carry.
#include <fmt/core.h>

#include <cctype>

#include "tb/equiv/misread.h"
#include "tb/equiv/prints.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"
#include "tb/util/pattern.h"

namespace cosim::equiv {
namespace {

// Whether more bits than its own may matter to an expression; what stands in an index, in braces or
// in the arguments of a function has its own ones.
bool grows(std::string_view expression) {
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
    if (std::isspace(static_cast<unsigned char>(c)) == 0) {
      is_name = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
    }
  }
  return false;
}

// Where an instance of this name connects an expression that grows to a port: by its name, or to
// one of those that are in order. npos where it does not.
std::size_t growing(const std::string& plain, const std::string& instance,
                    const std::string& port) {
  const rtl::Regex begin("\\b" + instance + "\\s*(\\[[^]]*\\]\\s*)?\\("),
      named("\\." + port + "\\s*\\("), by_name("^[^(]*\\(\\s*\\.");
  for (const rtl::Match& found : begin.all(plain)) {
    const std::size_t open = found.end() - 1;
    const std::string all = plain.substr(open, behind_arguments(plain, open) - open);
    if (!by_name.find(all)) {
      if (grows(std::string_view(all).substr(1, all.size() - 2))) return found.begin();
      continue;
    }
    const rtl::Match at = named.find(all);
    if (!at) continue;
    const std::size_t from = at.end(), to = behind_arguments(all, from - 1);
    if (grows(std::string_view(all).substr(from, to - from - 1))) return open + at.begin();
  }
  return std::string::npos;
}

}  // namespace

std::string cut_on_a_port(const std::string& said, const std::vector<SourceText>& sources) {
  static const Pattern resized(
      R"(Resizing cell port \S*?([A-Za-z_][\w$]*)(?:\[\d+\])?\.([A-Za-z_][\w$]*) from (\d+) bits to (\d+) bits)");
  for (const Pattern::Parts& part : resized.all(said)) {
    if (std::stoul(part[3]) >= std::stoul(part[4])) continue;
    for (const SourceText& source : sources) {
      const std::size_t at = growing(rtl::blanked(source.text), part[1], part[2]);
      if (at == std::string::npos) continue;
      return fmt::format(
          "{}: port {} of {} has {} bits, and the expression that it is given is read with {}: "
          "give it a wire of {} bits",
          place_in(source, at), part[2], part[1], part[4], part[3], part[4]);
    }
  }
  return "";
}

bool may_be_cut_on_ports(const std::vector<SourceText>& sources) {
  static const rtl::Regex port("\\.\\w+\\s*\\(");
  for (const SourceText& source : sources) {
    const std::string plain = rtl::blanked(source.text);
    for (const rtl::Match& found : port.all(plain)) {
      const std::size_t end = behind_arguments(plain, found.end() - 1);
      if (grows(std::string_view(plain).substr(found.end(), end - found.end() - 1))) return true;
    }
  }
  return false;
}

}  // namespace cosim::equiv

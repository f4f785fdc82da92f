// Indices of more than 32 bits, of which front ends and simulators take the lower 32 alone.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string>

#include "model/core/input_error.h"
#include "tb/equiv/misread.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"

namespace cosim::equiv {
namespace {

constexpr unsigned long most = 32;

// The bits of signals that are declared with numbers.
using Widths = std::map<std::string, unsigned long>;

Widths widths_in(const std::string& module) {
  static const rtl::Regex range("\\[\\s*([0-9]{1,6})\\s*:\\s*([0-9]{1,6})\\s*\\]\\s*([^][;()=]*)"),
      name("^\\s*([A-Za-z_][A-Za-z0-9_$]*)\\s*(,|$)");
  Widths widths;
  for (const rtl::Match& one : range.all(module)) {
    const unsigned long a = std::stoul(one[1]), b = std::stoul(one[2]);
    const unsigned long bits = (a > b ? a - b : b - a) + 1;
    std::string names = one[3];
    while (const rtl::Match next = name.find(names)) {
      // Of two with one name, as in functions, the one that has fewer.
      unsigned long& known = widths.try_emplace(next[1], bits).first->second;
      known = std::min(known, bits);
      names = names.substr(next.end());
    }
  }
  return widths;
}

// Whether an index may be 2^32 or more. One that is masked, compared, shifted down or cast is not
// looked into.
bool is_wide(const std::string& index, const Widths& widths) {
  static const rtl::Regex narrowed("[&%|<>!?]|==|'\\("), number("([0-9]{1,6})\\s*['{]"),
      word("(^|[^'.$`[:alnum:]_])([A-Za-z_][A-Za-z0-9_$]*)\\s*([[(.]?)"), inner("\\[[^][]*\\]");
  if (narrowed.find(index)) return false;
  const bool is_joined = index.find('{') != std::string::npos;
  unsigned long bits = 0;  // of all parts, or the most
  const auto add = [&](unsigned long more) {
    bits = is_joined ? bits + more : std::max(bits, more);
  };
  for (const rtl::Match& one : number.all(index)) add(std::stoul(one[1]));
  const std::string outside = inner.replaced(index, "[]");
  for (const rtl::Match& one : word.all(outside)) {
    const auto known = widths.find(one[2]);
    add(one[3].empty() && known != widths.end() ? known->second : 1);
  }
  return bits > most;
}

}  // namespace

void refuse_wide_indices(const SourceText& source) {
  static const rtl::Regex use("[A-Za-z0-9_$]\\s*\\["), part("[+-]:.*");
  static const rtl::Regex module("\\bmodule\\b");
  const std::string all = rtl::blanked(source.text);
  for (const rtl::Match& begin : module.all(all)) {
    const std::size_t from = begin.begin();
    const std::string plain = all.substr(from, all.find("endmodule", from) - from);
    const Widths widths = widths_in(plain);
    for (const rtl::Match& found : use.all(plain)) {
      for (const std::string& whole : indices_at(plain, found.end() - 1)) {
        const std::string index = part.replaced(whole, "");
        if (index.find(':') != std::string::npos || !is_wide(index, widths)) continue;
        throw InputError(fmt::format(
            "{}: an index of more than 32 bits: front ends and simulators take its lower 32 alone: "
            "give it as many as it needs",
            place_in(source, from + found.begin())));
      }
    }
  }
}

}  // namespace cosim::equiv

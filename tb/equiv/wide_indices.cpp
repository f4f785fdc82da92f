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

Widths widths_in(const std::string& plain) {
  static const rtl::Regex range("\\[\\s*([0-9]{1,6})\\s*:\\s*([0-9]{1,6})\\s*\\]\\s*([^][;()=]*)"),
      type("\\b(longint|time)\\s+(unsigned\\s+|signed\\s+)?([^][;()=]*)"),
      name("^\\s*([A-Za-z_][A-Za-z0-9_$]*)\\s*(,|$)");
  Widths widths;
  const auto add = [&](std::string names, unsigned long bits) {
    while (const rtl::Match one = name.find(names)) {
      unsigned long& most_bits = widths[one[1]];
      most_bits = std::max(most_bits, bits);
      names = names.substr(one.end());
    }
  };
  for (const rtl::Match& one : range.all(plain)) {
    const unsigned long a = std::stoul(one[1]), b = std::stoul(one[2]);
    add(one[3], (a > b ? a - b : b - a) + 1);
  }
  for (const rtl::Match& one : type.all(plain)) add(one[3], 64);
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
  const std::string plain = rtl::blanked(source.text);
  const Widths widths = widths_in(plain);
  for (const rtl::Match& found : use.all(plain)) {
    for (const std::string& whole : indices_at(plain, found.end() - 1)) {
      const std::string index = part.replaced(whole, "");
      if (index.find(':') != std::string::npos || !is_wide(index, widths)) continue;
      throw InputError(
          fmt::format("{}: an index of more than 32 bits: front ends and simulators take its lower "
                      "32 alone: give it as many as it needs",
                      place_in(source, found.begin())));
    }
  }
}

}  // namespace cosim::equiv

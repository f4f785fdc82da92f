#include <algorithm>
#include <cstddef>

#include "model/core/input_error.h"
#include "tb/rtl/regex.h"
#include "tb/rtl/vhdl.h"

namespace cosim::rtl {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& text, std::size_t at,
                         const std::string& why) {
  const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
  throw InputError(file + ':' + std::to_string(line) + ": " + why);
}

// GHDL takes the choices of case? and select? as those of case, where a - matches a - alone.
void refuse_matching(const std::string& file, const std::string& text) {
  static const Regex matching("\\b(case|select)\\s*\\?", REG_ICASE),
      open("\"[01xzXZuUwWlLhH]*-[01xzXZuUwWlLhH-]*\"");
  const Match found = matching.find(text);
  if (!found || !open.find(text)) return;
  refuse(file, text, found.begin(),
         "GHDL does not match the - of a choice of " + in_small_letters(found[1]) +
             "?: write if with std_match");
}

// A signal of 0 or 1 is equal to no 'H', '-' or 'X'; GHDL makes a 1 of an H, and any value of the
// others. Simulation alone has such values, and an assertion is of simulation.
void refuse_metavalues(const std::string& file, const std::string& text) {
  static const std::string bits =
                               "\"[01]*(-[01-]*|x[01x]*|z[01z]*|u[01u]*|w[01w]*|l[01l]*|h[01h]*)\"",
                           value = "('[-xzuwlh]'|" + bits + ")";
  static const Regex constant("\\bconstant\\s+(\\w+)\\s*:[^;:]*:=\\s*" + value + "\\s*;",
                              REG_ICASE),
      assertion("\\bassert\\b", REG_ICASE);
  std::string values = value;
  for (const Match& one : constant.all(text)) values += "|\\b" + one[1] + "\\b";
  const Regex behind("(^|[^<>:/=?])/?=\\s*(" + values + ")", REG_ICASE),
      before("(" + values + ")\\s*/?=[^>=]", REG_ICASE);
  const auto refuse_in = [&](const Match& found, const std::string& what) {
    const std::size_t last = text.find_last_of(';', found.begin());
    const std::size_t from = last == std::string::npos ? 0 : last;
    if (assertion.find(text.substr(from, found.begin() - from))) return;
    refuse(file, text, found.begin() + 1,
           "GHDL misreads a comparison with " + what + ", which no signal of 0 and 1 is equal to");
  };
  for (const Match& found : behind.all(text)) refuse_in(found, found[2]);
  for (const Match& found : before.all(text)) refuse_in(found, found[1]);
}

}  // namespace

void refuse_misread_vhdl(const std::string& file, const std::string& text) {
  refuse_matching(file, text);
  refuse_metavalues(file, text);
}

}  // namespace cosim::rtl

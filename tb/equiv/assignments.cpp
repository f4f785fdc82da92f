// Variables that one block assigns in two ways, of which a front end takes the later one in the
// text.
#include <fmt/core.h>

#include <map>

#include "model/core/input_error.h"
#include "tb/equiv/misread.h"
#include "tb/equiv/prints.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"

namespace cosim::equiv {

void refuse_mixed_assignments(const SourceText& source) {
  static const rtl::Regex block("\\balways(_ff|_comb|_latch)?\\b"), loop("\\bfor\\s*\\("),
      assignment(
          "(^|[;):]|\\b(begin|else|do)\\b)\\s*(\\{[^{};=]*\\}|[A-Za-z_][A-Za-z0-9_$.]*(\\s*"
          "\\[[^;=]*\\])?)\\s*(<?=)\\s*(#\\s*[^ (;]+)?[^=]"),
      index("\\[[^]]*\\]"), word("[A-Za-z_][A-Za-z0-9_$.]*"), otherwise("\\belse\\b"),
      declaration("\\b(reg|logic|integer|int|bit|byte)\\b[^;]*;");
  const std::string plain = rtl::blanked(source.text);
  for (const rtl::Match& found : block.all(plain)) {
    std::size_t begin = plain.find_first_not_of(" \t\r\n", found.end());
    if (begin == std::string::npos) continue;
    if (plain[begin] == '@') begin = behind_arguments(plain, begin + 1);
    const std::string own = plain.substr(begin, behind_statement(plain, begin, true) - begin);
    std::string body = own;
    for (const rtl::Match& one : declaration.all(own)) blank(body, one.begin(), one.end());
    for (const rtl::Match& one : loop.all(own)) {
      blank(body, one.begin(), behind_arguments(own, one.end() - 1));
    }
    // Of each variable, by "=", or "<=" and its delay: where it was assigned so last.
    std::map<std::string, std::map<std::string, std::size_t>> last;
    for (const rtl::Match& one : assignment.all(body)) {
      const std::string names = index.replaced(one[3], ""), way = one[5] + one[6];
      for (const rtl::Match& name : word.all(names)) {
        for (const auto& [other, at] : last[name[0]]) {
          const std::string between = body.substr(at, one.begin() - at);
          if (other == way || other == "=" || otherwise.find(between)) continue;
          throw InputError(
              fmt::format("{}: {} is assigned by {} behind {} in one block: front ends take the "
                          "last in the text, and not the last in time",
                          place_in(source, begin + one.begin(3)), name[0], way, other));
        }
        last[name[0]][way] = one.end();
      }
    }
  }
}

}  // namespace cosim::equiv

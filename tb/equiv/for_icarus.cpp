#include "tb/equiv/for_icarus.h"

#include "tb/util/pattern.h"

namespace cosim::equiv {

std::string for_icarus(const std::string& text) {
  static const Pattern select(
      R"((<<<?=?|>>>?=?|\[)([\s(+]*)([A-Za-z_][\w$.]*\s*\[[^\[\]?;]*:[^\[\]?;]*\]))");
  // Of a count that is a word, or a part of one: of others it had to be known where they end.
  static const Pattern shift(
      R"(([\s;)])([A-Za-z_][\w$.]*(?:\[[^\[\];]*\])*)\s*(<<<?|>>>?)=\s*([A-Za-z_][\w$.]*(?:\[[^\[\];]*\])*\s*;))");
  static const Pattern number(R"(([^\w\s'])(\s*)('[sS][bBoOdDhH]\w{1,8}\b))");
  return number.replaced(shift.replaced(select.replaced(text, "$1$2{$3}"), "$1$2 = $2 $3 $4"),
                         "$1$2 32$3");
}

}  // namespace cosim::equiv

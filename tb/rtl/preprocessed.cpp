#include "tb/rtl/preprocessed.h"

#include <set>

#include "tb/rtl/regex.h"

namespace cosim::rtl {

std::string with_warnings(const std::string& text, const std::vector<std::string>& files) {
  static const Regex lint_off("/\\*\\s*verilator lint_off\\b([^*]|\\*+[^*/])*\\*+/", REG_NEWLINE);
  static const Regex latch("\\balways_latch\\b");
  static const Regex first_line("^`line 1 \"([^\n]*)\"", REG_NEWLINE);
  std::set<std::string> left(files.begin(), files.end());
  bool is_old = false;
  return first_line.replaced(latch.replaced(lint_off.replaced(text, ""), "always @*"),
                             [&](const Match& m) {
                               if (left.erase(m[1]) == 0) return m[0];
                               std::string words = is_old ? "`end_keywords\n" : "";
                               is_old = m[1].ends_with(".v");
                               if (is_old) words += "`begin_keywords \"1364-2005\"\n";
                               return words + m[0];
                             });
}

}  // namespace cosim::rtl

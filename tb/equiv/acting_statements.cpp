// Assertions and what is printed, where they do more than that: front ends leave them out.
#include <fmt/core.h>

#include "model/core/input_error.h"
#include "tb/equiv/misread.h"
#include "tb/equiv/prints.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"

namespace cosim::equiv {
namespace {

bool counts(const std::string& text) {
  return text.find("++") != std::string::npos || text.find("--") != std::string::npos;
}

// Whether a statement does more than system tasks and macros, which may stand in `if`.
bool acts(std::string statement) {
  static const rtl::Regex call("[$`]\\w+|\\bif\\b"), word("\\b(begin|end|else)\\b|\\b\\w+\\s*:");
  for (rtl::Match found = call.find(statement); found; found = call.find(statement)) {
    blank(statement, found.begin(), behind_arguments(statement, found.end()));
  }
  return word.replaced(statement, "").find_first_not_of(" \t\r\n;") != std::string::npos;
}

// An assertion that does more than print, by its action or its condition: front ends do neither.
void refuse_acting_assertions(const SourceText& source) {
  static const rtl::Regex assertion(
      "(^|[^`$._[:alnum:]])(assert|assume|cover)\\b\\s*(property\\b|sequence\\b|final\\b|#\\s*0)?"
      "\\s*"
      "\\("),
      otherwise("^\\s*else\\b");
  const std::string plain = rtl::blanked(source.text);
  for (const rtl::Match& found : assertion.all(plain)) {
    const std::size_t from = behind_arguments(plain, found.end() - 1);
    std::size_t at = from;
    const auto over_else = [&] {
      const rtl::Match word = otherwise.find(std::string_view(plain).substr(at));
      if (word) at += word.end();
      return bool(word);
    };
    if (over_else()) {
      at = behind_statement(plain, at);
    } else {
      // Behind an empty one an else is of an if.
      at = behind_statement(plain, at);
      const bool is_empty =
          plain.substr(from, at - from).find_first_not_of(" \t\r\n") == at - from - 1;
      if (!is_empty && over_else()) at = behind_statement(plain, at);
    }
    const std::string condition = plain.substr(found.end(), from - found.end());
    if (!counts(condition) && !acts(plain.substr(from, at - from))) continue;
    throw InputError(fmt::format(
        "{}: an assertion that does more than print, which no front end reads: its condition "
        "counts, or its action assigns or calls something",
        place_in(source, found.begin(2))));
  }
}

// What is printed, if it counts or assigns: front ends leave it out.
void refuse_acting_prints(const SourceText& source) {
  static const rtl::Regex task("\\$\\w+\\s*\\("), assignment("[^=!<>]=[^=]");
  const std::string plain = rtl::blanked(source.text);
  for (const rtl::Match& found : task.all(plain)) {
    const std::size_t end = behind_arguments(plain, found.end() - 1);
    const std::string arguments = plain.substr(found.end(), end - found.end());
    if (!counts(arguments) && !assignment.find(arguments)) continue;
    throw InputError(
        fmt::format("{}: an argument that counts or assigns, which no front end reads where it is "
                    "printed",
                    place_in(source, found.begin())));
  }
}

}  // namespace

void refuse_acting_statements(const SourceText& source) {
  refuse_acting_assertions(source);
  refuse_acting_prints(source);
}

}  // namespace cosim::equiv

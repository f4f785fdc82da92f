#include "tb/equiv/assertions.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>
#include <vector>

#include "tb/equiv/prints.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"

namespace cosim::equiv {
namespace {

// Behind the statement that prints, or is empty, at `at`; npos where it is another one.
std::size_t behind_printing(std::string_view plain, std::size_t at) {
  static const rtl::Regex statement("^\\s*(\\$\\w+\\s*)?");
  const rtl::Match found = statement.find(plain.substr(at));
  const std::size_t end = behind_arguments(plain, at + found.end());
  const std::size_t semicolon = plain.find_first_not_of(" \t\r\n", end);
  const bool is_whole = semicolon != std::string_view::npos && plain[semicolon] == ';';
  return is_whole ? semicolon + 1 : std::string_view::npos;
}

// Behind an assertion, of which the arguments end at `at`; npos where it does more than print.
std::size_t behind_actions(std::string_view plain, std::size_t at) {
  static const rtl::Regex otherwise("^\\s*else\\b");
  const rtl::Match first = otherwise.find(plain.substr(at));
  std::size_t end = behind_printing(plain, first ? at + first.end() : at);
  if (first || end == std::string_view::npos) return end;
  const rtl::Match second = otherwise.find(plain.substr(end));
  return second ? behind_printing(plain, end + second.end()) : end;
}

// Where what stands in a text is an item of a case, from each place on.
std::map<std::size_t, bool> cases_in(std::string_view plain) {
  static const rtl::Regex word("\\b(case[xz]?|begin|fork|endcase|end|join(_any|_none)?)\\b");
  std::map<std::size_t, bool> is_case{{0, false}};
  std::vector<bool> open;  // a case, or else
  for (const rtl::Match& found : word.all(plain)) {
    const bool is_end = found[1].starts_with("e") || found[1].starts_with("j");
    if (!is_end) {
      open.push_back(found[1].starts_with("case"));
    } else if (!open.empty()) {
      open.pop_back();
    }
    is_case[found.end()] = !open.empty() && open.back();
  }
  return is_case;
}

// Whether a statement has to be at this place, as behind if (a).
bool needs_statement(std::string_view plain, std::size_t at) {
  static const rtl::Regex before("(\\)|\\belse)\\s*$");
  constexpr std::size_t enough = 200;
  const std::size_t from = at < enough ? 0 : at - enough;
  return bool(before.find(plain.substr(from, at - from)));
}

}  // namespace

std::string without_assertions(std::string text) {
  static const rtl::Regex assertion(
      "(\\b\\w+\\s*:\\s*)?\\b(assert|assume|cover|restrict)\\s+(property|sequence)\\b");
  static const rtl::Regex declaration("\\b(property|sequence)\\s+\\w");
  static const rtl::Regex defaults("\\bdefault\\s+(clocking|disable\\s+iff)\\b");
  std::string plain = rtl::blanked(text);
  const auto remove = [&](std::size_t from, std::size_t to) {
    blank(text, from, to);
    blank(plain, from, to);
  };
  const std::map<std::size_t, bool> cases = cases_in(plain);
  for (rtl::Match found = assertion.find(plain); found;) {
    // The label of the assertion, or of an item that has nothing else.
    const bool is_item = std::prev(cases.upper_bound(found.begin()))->second;
    const std::size_t from = is_item ? found.begin(2) : found.begin(), behind = found.end();
    const std::size_t end = behind_actions(plain, behind_arguments(plain, behind));
    if (end != std::string::npos) {
      const bool is_statement = is_item || needs_statement(plain, from);
      remove(from, end);
      if (is_statement) text[end - 1] = plain[end - 1] = ';';
    }
    found = assertion.find(plain, behind);
  }
  for (rtl::Match found = declaration.find(plain); found;) {
    const std::size_t from = found.begin();
    const std::string last = "end" + found[1];
    const std::size_t at = plain.find(last, from);
    if (at == std::string::npos) break;
    static const rtl::Regex label("^\\s*:\\s*\\w+");
    const std::size_t end = at + last.size();
    const rtl::Match name = label.find(std::string_view(plain).substr(end));
    remove(from, name ? end + name.end() : end);
    found = declaration.find(plain, from);
  }
  for (rtl::Match found = defaults.find(plain); found;) {
    const std::size_t from = found.begin(), semicolon = plain.find(';', from);
    if (semicolon == std::string::npos) break;
    // A block of its own, or the name of one that is declared.
    const bool is_block = plain.find('@', from) < semicolon;
    const std::size_t last = is_block ? plain.find("endclocking", from) : semicolon;
    if (last == std::string::npos) break;
    remove(from, last + (is_block ? std::string_view("endclocking").size() : 1));
    found = defaults.find(plain, from);
  }
  return text;
}

std::string without_unique(std::string text) {
  static const rtl::Regex word("\\b(unique0?|priority)\\s+(if|case[xz]?)\\b");
  const std::string plain = rtl::blanked(text);
  for (const rtl::Match& found : word.all(plain)) {
    blank(text, found.begin(1), found.end(1));
  }
  return text;
}

}  // namespace cosim::equiv

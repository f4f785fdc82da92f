#include "tb/equiv/front_end.h"

#include <cctype>
#include <map>
#include <string_view>

#include "tb/equiv/prints.h"

namespace cosim::equiv {
namespace {

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_of_size(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("_$.:`").find(c) != std::string_view::npos;
}

// Where the size begins that ends at `end`: a number, a name or an expression in brackets.
std::size_t begin_of_size(std::string_view text, std::size_t end) {
  while (end > 0 && is_blank(text[end - 1])) --end;
  std::size_t at = end;
  int depth = 0;
  while (at > 0 && (depth > 0 || text[at - 1] == ')')) {
    --at;
    depth += text[at] == ')' ? 1 : text[at] == '(' ? -1 : 0;
    if (depth == 0) return at;
  }
  while (at > 0 && is_of_size(text[at - 1])) --at;
  return at;
}

}  // namespace

std::string with_casts_apart(const std::string& text) {
  std::string code = text;  // without comments and strings
  for (std::size_t at = 0; at < code.size();) {
    const std::size_t next = skipped(text, at);
    if (next == at) {
      ++at;
    } else {
      for (; at < next; ++at) code[at] = ' ';
    }
  }
  std::map<std::size_t, std::string> brackets;
  for (std::size_t at = 0; (at = code.find('\'', at)) != std::string::npos; ++at) {
    const std::size_t begin = begin_of_size(code, at), end = behind_arguments(code, at + 1);
    std::size_t before = begin;
    while (before > 0 && is_blank(code[before - 1])) --before;
    if (end == at + 1 || before == 0 || begin == at) continue;
    if (std::string_view("~&|^!+-").find(code[before - 1]) == std::string_view::npos) continue;
    brackets[begin] += '(';
    brackets[end] += ')';
  }
  std::string all = text;
  for (auto at = brackets.rbegin(); at != brackets.rend(); ++at) {
    all.insert(at->first, at->second);
  }
  return all;
}

}  // namespace cosim::equiv

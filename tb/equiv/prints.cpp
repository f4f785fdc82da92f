#include "tb/equiv/prints.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace cosim::equiv {
namespace {

constexpr std::array prints{"display", "displayb", "displayh",  "write", "writeh",
                            "strobe",  "monitor",  "monitoron", "error", "warning",
                            "info",    "fatal",    "fdisplay"};

bool is_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}

}  // namespace

void blank(std::string& text, std::size_t from, std::size_t to) {
  std::replace_if(
      text.begin() + std::ptrdiff_t(from), text.begin() + std::ptrdiff_t(to),
      [](char c) { return c != '\n'; }, ' ');
}

std::size_t skipped(std::string_view text, std::size_t at) {
  const auto behind = [&](std::string_view end, std::size_t from) {
    const std::size_t found = text.find(end, from);
    return found == std::string_view::npos ? text.size() : found + end.size();
  };
  if (text.substr(at, 2) == "//") return behind("\n", at);
  if (text.substr(at, 2) == "/*") return behind("*/", at + 2);
  if (text[at] != '"') return at;
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return std::min(at + 1, text.size());
}

std::size_t behind_arguments(std::string_view text, std::size_t at) {
  std::size_t open = at;
  while (open < text.size() && std::isspace(static_cast<unsigned char>(text[open])) != 0) ++open;
  if (open == text.size() || text[open] != '(') return at;
  int depth = 0;
  for (at = open; at < text.size();) {
    if (const std::size_t next = skipped(text, at); next != at) {
      at = next;
      continue;
    }
    depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
    ++at;
    if (depth == 0) break;
  }
  return at;
}

std::string without_prints(std::string text) {
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t next = skipped(text, at); next != at) {
      at = next;
      continue;
    }
    const bool begins = text[at] == '$' && (at == 0 || !is_of_name(text[at - 1]));
    ++at;
    if (!begins) continue;
    std::size_t end = at;
    while (end < text.size() && is_of_name(text[end])) ++end;
    const std::string_view name = std::string_view(text).substr(at, end - at);
    if (std::ranges::find(prints, name) == prints.end()) continue;
    const std::size_t from = at - 1;
    at = behind_arguments(text, end);
    blank(text, from, at);
  }
  return text;
}

}  // namespace cosim::equiv

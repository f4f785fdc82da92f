#include "tb/equiv/vhdl_run.h"

#include <algorithm>
#include <cctype>

#include "tb/util/pattern.h"

namespace cosim::equiv {
namespace {

// Behind the string, the character or the extended name that begins at `at`; `at` where none does.
std::size_t behind_quoted(std::string_view text, std::size_t at) {
  if (text[at] == '\'') return at + 2 < text.size() && text[at + 2] == '\'' ? at + 3 : at;
  if (text[at] != '"' && text[at] != '\\') return at;
  const std::size_t end = text.find(text[at], at + 1);
  return end == std::string_view::npos ? text.size() : end + 1;
}

// With blanks in place of comments.
std::string without_vhdl_comments(std::string text) {
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t next = behind_quoted(text, at); next != at) {
      at = next;
      continue;
    }
    const std::string_view begins = std::string_view(text).substr(at, 2);
    std::size_t end = at;
    if (begins == "--") end = std::min(text.find('\n', at), text.size());
    if (begins == "/*") {
      end = text.find("*/", at);
      end = end == std::string::npos ? text.size() : end + 2;
    }
    std::fill(text.begin() + static_cast<long>(at), text.begin() + static_cast<long>(end), ' ');
    at = std::max(end, at + 1);
  }
  return text;
}

std::string vhdl_trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1));
}

// The parts between such characters that are in no brackets.
std::vector<std::string> vhdl_parts(std::string_view text, char end) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t next = std::max(behind_quoted(text, at), at + 1);
    if (next == at + 1) depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
    if (text[at] == end && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += text.substr(at, next - at);
    }
    at = next;
  }
  return parts;
}

// What is in the brackets that open first behind `at`; `at` is then behind them.
std::string in_vhdl_brackets(std::string_view text, std::size_t& at) {
  const std::size_t begin = text.find('(', at) + 1;
  int depth = 1;
  for (at = begin; at < text.size() && depth > 0;) {
    const std::size_t next = std::max(behind_quoted(text, at), at + 1);
    if (next == at + 1) depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
    at = next;
  }
  return std::string(text.substr(begin, at - begin - 1));
}

}  // namespace

std::string small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::optional<VhdlEntity> entity_in(std::string_view file, const std::string& name) {
  static const Pattern heads(R"(\bentity\s+(\w+|\\[^\\]*\\)\s+is\b)"),
      clauses(R"(\b(library|use)\s[^;]*;)"), ends(R"(\bend\b[^;]*;)"),
      declaration(
          R"(\s*(?:signal\s|constant\s)?\s*([^:]*?)\s*:\s*(?:(in|out|inout|buffer|linkage)\s)?\s*([\s\S]*))"),
      clause(R"(\s*(generic|port)\s*\([\s\S]*)");
  const std::string text = without_vhdl_comments(std::string(file)), small = small_letters(text);
  std::string wanted;
  for (const Pattern::Parts& head : heads.all(small)) {
    if (head[1] == small_letters(name)) wanted = head[0];
  }
  if (wanted.empty()) return std::nullopt;
  std::size_t at = small.find(wanted);
  VhdlEntity entity;
  entity.name = name;
  // The clauses in front of it, behind the unit before.
  std::size_t unit = 0;
  const std::string before = small.substr(0, at);
  for (const Pattern::Parts& end : ends.all(before))
    unit = before.find(end[0], unit) + end[0].size();
  for (const Pattern::Parts& part : clauses.all(before.substr(unit)))
    entity.context += part[0] + '\n';
  at += wanted.size();
  while (clause.in(small.substr(at, small.find_first_of("(;", at) - at + 1))) {
    const bool is_port = vhdl_trimmed(small.substr(at, 8)).starts_with("port");
    const std::string list = in_vhdl_brackets(text, at);
    at = text.find(';', at) + 1;
    if (!is_port) entity.generics = list;
    for (const std::string& one : vhdl_parts(list, ';')) {
      const std::string type_text = vhdl_parts(one, ':').size() > 1 ? one : "";
      const Pattern::Parts parts = declaration.whole(type_text);
      if (parts.empty()) continue;
      for (const std::string& each : vhdl_parts(parts[1], ',')) {
        if (!is_port) entity.generic_names.push_back(vhdl_trimmed(each));
        if (!is_port) continue;
        const std::string type = parts[3].substr(0, parts[3].find(":="));
        entity.ports.push_back(
            {vhdl_trimmed(each), parts[2].empty() ? "in" : parts[2], vhdl_trimmed(type)});
      }
    }
  }
  return entity;
}

}  // namespace cosim::equiv

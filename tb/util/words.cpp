#include "tb/util/words.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "tb/util/finite.h"

namespace cosim {
namespace {

// The bytes of the printable UTF-8 character that begins there; 0 where none does.
std::size_t character_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xf5   ? 0
                             : first >= 0xf0 ? 4
                             : first >= 0xe0 ? 3
                             : first >= 0xc2 ? 2
                                             : 0;
  if (at + length > text.size()) return 0;
  for (std::size_t i = at + 1; i < at + length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  return length;
}

std::string& the_program() {
  static std::string name = "cosim";
  return name;
}

std::string& the_call() {
  static std::string call;
  return call;
}

bool is_half_integer(double x) { return 2 * x == std::floor(2 * x); }

}  // namespace

std::string count(std::uint64_t n, const std::string& noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

std::string amount(double n, const std::string& noun) {
  constexpr int most_decimals = 12;
  std::string text = fmt::format("{}", finite(n));  // the shortest that is the same double
  for (int decimals = 3; decimals <= most_decimals; ++decimals) {
    std::string rounded = fmt::format("{:.{}f}", n, decimals);
    if (rounded.size() >= text.size()) break;
    if (!is_half_integer(std::strtod(rounded.c_str(), nullptr))) {
      text = std::move(rounded);
      break;
    }
  }
  return text + " " + noun + (n == 1 ? "" : "s");
}

std::string one_line(std::string text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_at(text, i);
    if (length == 0) text[i] = '?';
    i += std::max<std::size_t>(length, 1);
  }
  return text;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  if (text.size() <= longest) return "'" + one_line(std::string(text)) + "'";
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // UTF-8
  return "'" + one_line(std::string(text.substr(0, end))) + "...'";
}

std::vector<std::string> words_in(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<std::string> parts_in(std::string_view text, char end) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    parts.emplace_back(text.substr(0, text.find(end)));
    text.remove_prefix(std::min(text.size(), parts.back().size() + 1));
  }
  return parts;
}

bool is_like(std::string_view text, std::string_view pattern) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return text == pattern;
  if (!text.starts_with(pattern.substr(0, star))) return false;
  for (std::size_t i = star; i <= text.size(); ++i) {
    if (is_like(text.substr(i), pattern.substr(star + 1))) return true;
  }
  return false;
}

const std::string& program_name() { return the_program(); }

const std::string& program_call() { return the_call().empty() ? program_name() : the_call(); }

void name_program(const std::string& name, const std::string& call) {
  the_program() = name;
  the_call() = call;
}

void complain(const std::string& text) {
  std::fputs((program_name() + ": " + one_line(text) + '\n').c_str(), stderr);
}

}  // namespace cosim

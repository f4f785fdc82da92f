#include "tb/cli/words.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace cosim::cli {
namespace {

bool is_half_integer(double x) { return 2 * x == std::floor(2 * x); }

}  // namespace

std::string count(std::uint64_t n, const std::string& noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

std::string in_steps(double length) {
  constexpr int most_decimals = 12;
  std::string text = fmt::format("{}", length);  // the shortest that is the same double
  for (int decimals = 3; decimals <= most_decimals; ++decimals) {
    std::string rounded = fmt::format("{:.{}f}", length, decimals);
    if (rounded.size() >= text.size()) break;
    if (!is_half_integer(std::strtod(rounded.c_str(), nullptr))) {
      text = std::move(rounded);
      break;
    }
  }
  return text + (length == 1 ? " step" : " steps");
}

std::string one_line(std::string text) {
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = '?';
  }
  return text;
}

std::string quoted(const std::string& text) {
  constexpr std::size_t longest = 40;
  if (text.size() <= longest) return "'" + one_line(text) + "'";
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // UTF-8
  return "'" + one_line(text.substr(0, end)) + "...'";
}

}  // namespace cosim::cli

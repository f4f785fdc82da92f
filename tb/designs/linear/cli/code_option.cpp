#include "tb/designs/linear/cli/code_option.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

linear::Code parse_code(const std::string& text, int m) {
  const bool hexadecimal = text.starts_with("0x");
  const std::string digits = text.substr(hexadecimal ? 2 : 0);
  std::uint64_t value = 0;
  const char* end = digits.data() + digits.size();
  const auto [rest, error] = std::from_chars(digits.data(), end, value, hexadecimal ? 16 : 2);
  const bool is_number = error == std::errc{} && rest == end && !digits.starts_with('-');
  const bool fits = hexadecimal ? value >> m == 0 : digits.size() == static_cast<std::size_t>(m);
  if (!is_number || !fits) {
    throw InputError(fmt::format("--code: {} is not best, greedy, {} bits (M={}) or 0x0 to {:#x}",
                                 in_quotes(text), m, m, (std::uint64_t{1} << m) - 1));
  }
  return value;
}

}  // namespace

std::optional<int> width_of(const Text& code) {
  if (!code || code->empty() || code->find_first_not_of("01") != std::string::npos) return {};
  return static_cast<int>(std::min<std::size_t>(code->size(), 64));
}

linear::Code (*code_rule(const Text& code))(int, std::int64_t, std::int64_t) {
  const std::string rule = code.value_or("best");
  if (rule == "best") return linear::best_code;
  if (rule == "greedy") return linear::greedy_code;
  throw InputError(fmt::format("--code: {} is not best or greedy", in_quotes(rule)));
}

ChosenCode choose_code(const Text& code, int m, std::int64_t major,
                       std::optional<std::int64_t> minor) {
  const std::string text = code.value_or("best");
  if (text == "best" || text == "greedy") {
    if (!minor) throw InputError("--minor: is needed where --code gives no bits");
    return {code_rule(text)(m, major, *minor), *minor, text};
  }
  const linear::Code bits = parse_code(text, m);
  const std::int64_t given = linear::minor_steps(m, major, bits);
  if (minor && given != *minor) {
    throw InputError(fmt::format("--code: {} gives {} on a line of {}, not {}", in_quotes(text),
                                 count(static_cast<std::uint64_t>(given), "minor step"), major,
                                 *minor));
  }
  return {bits, given, ""};
}

}  // namespace cosim::cli

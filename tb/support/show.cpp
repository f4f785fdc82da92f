#include "tb/support/show.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

namespace cosim {
namespace {

std::string digits(const Field& field, Word value) {
  return fmt::format("{:0{}b}", static_cast<std::uint64_t>(value), field.width);
}

// A number of all of `text`.
template <class Number>
std::optional<Number> parse(std::string_view text, int base = 10) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, base);
  if (error != std::errc() || stop != end) return {};
  return number;
}

std::optional<Word> parse_raw(const Field& field, std::string_view text) {
  switch (field.format) {
    case Format::flag:
    case Format::number:
    case Format::bits: {
      const int base = field.format != Format::bits ? 10 : field.width <= 16 ? 2 : 16;
      const auto number = parse<std::uint64_t>(text, base);
      if (!number) return {};
      return static_cast<Word>(*number);
    }
    case Format::twos_complement: {
      const auto number = parse<Word>(text);
      if (!number) return {};
      return low_bits(*number, field.width);
    }
    case Format::ones_complement: {
      if (text == "-0") return ones(field.width);
      const auto number = parse<Word>(text);
      if (!number) return {};
      return to_ones_complement(*number, field.width);
    }
    case Format::ones_quarters: {
      const bool negative = text.starts_with('-');
      const std::size_t point = text.find('.');
      if (point == std::string_view::npos || point + 3 != text.size()) return {};
      const std::size_t sign = negative ? 1 : 0;
      const auto whole = parse<std::uint32_t>(text.substr(sign, point - sign));
      const auto hundredths = parse<std::uint32_t>(text.substr(point + 1));
      if (!whole || !hundredths) return {};
      const Word size = Word{*whole} * 4 + *hundredths / 25;
      return negative ? ones(field.width) ^ size : size;
    }
  }
  return {};
}

}  // namespace

std::string show_short(const Field& field, Word value) {
  switch (field.format) {
    case Format::flag:
    case Format::number:
      return fmt::format("{}", static_cast<std::uint64_t>(value));
    case Format::bits:
      if (field.width <= 16) return digits(field, value);
      return fmt::format("{:0{}x}", static_cast<std::uint64_t>(value), (field.width + 3) / 4);
    case Format::twos_complement:
      return fmt::format("{}", from_twos_complement(value, field.width));
    case Format::ones_complement: {
      const Word number = from_ones_complement(value, field.width);
      return number == 0 && value != 0 ? "-0" : fmt::format("{}", number);
    }
    case Format::ones_quarters: {
      const Word number = from_ones_complement(value, field.width);
      const Word size = number < 0 ? -number : number;
      const char* sign = bit(value, field.width - 1) ? "-" : "";
      return fmt::format("{}{}.{:02}", sign, size / 4, size % 4 * 25);
    }
  }
  return {};
}

std::optional<Word> parse_short(const Field& field, std::string_view text) {
  const std::optional<Word> value = parse_raw(field, text);
  // What is out of range, or written another way, does not come back the same.
  if (!value || low_bits(*value, field.width) != *value) return {};
  if (show_short(field, *value) != text) return {};
  return value;
}

std::string show(const Field& field, Word value) {
  const std::string number = show_short(field, value);
  const std::string bits = digits(field, value);
  return number == bits ? bits : fmt::format("{} ({})", bits, number);
}

std::size_t show_width(const Field& field) {
  const Word most_negative = shift_left(1, field.width - 1);
  return std::max(show_short(field, ones(field.width)).size(),
                  show_short(field, low_bits(most_negative, field.width)).size());
}

}  // namespace cosim

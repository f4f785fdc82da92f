#include "tb/util/show.h"

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

// What one in the last of so many decimals is, in units of the last of so many bits.
std::uint64_t last_decimal(int fraction) {
  std::uint64_t power = 1;
  for (int i = 0; i < fraction; ++i) power *= 5;
  return power;
}

// A number without its sign, with as many decimals as its field has fraction bits: no fewer tell
// all its values.
std::string show_size(const Field& field, std::uint64_t size) {
  if (field.fraction == 0) return fmt::format("{}", size);
  const auto part = static_cast<std::uint64_t>(low_bits(static_cast<Word>(size), field.fraction));
  return fmt::format("{}.{:0{}}", size >> field.fraction, part * last_decimal(field.fraction),
                     field.fraction);
}

std::optional<Word> parse_size(const Field& field, std::string_view text) {
  const std::size_t point = std::min(text.find('.'), text.size());
  const auto whole = parse<std::uint64_t>(text.substr(0, point));
  if (!whole) return {};
  std::uint64_t size = *whole << field.fraction;
  if (field.fraction > 0) {
    const auto decimals = parse<std::uint64_t>(text.substr(std::min(point + 1, text.size())));
    if (!decimals) return {};
    size += *decimals / last_decimal(field.fraction);
  } else if (point != text.size()) {
    return {};
  }
  return static_cast<Word>(size);
}

std::optional<Word> parse_raw(const Field& field, std::string_view text) {
  switch (field.format) {
    case Format::bits: {
      const auto number = parse<std::uint64_t>(text, field.width <= 16 ? 2 : 16);
      if (!number) return {};
      return static_cast<Word>(*number);
    }
    case Format::flag:
    case Format::number:
    case Format::twos_complement:
    case Format::ones_complement: {
      const bool negative = text.starts_with('-');
      const auto size = parse_size(field, text.substr(negative ? 1 : 0));
      if (!size) return {};
      if (!negative) return *size;
      if (field.format == Format::ones_complement) return ones(field.width) ^ *size;
      return low_bits(static_cast<Word>(-static_cast<std::uint64_t>(*size)), field.width);
    }
  }
  return {};
}

bool has_name(const Field& field, Word value) {
  return value >= 0 && static_cast<std::size_t>(value) < field.named;
}

}  // namespace

std::string show_short(const Field& field, Word value) {
  if (has_name(field, value)) return field.names[static_cast<std::size_t>(value)];
  switch (field.format) {
    case Format::flag:
    case Format::number:
      return show_size(field, static_cast<std::uint64_t>(value));
    case Format::bits:
      if (field.width <= 16) return digits(field, value);
      return fmt::format("{:0{}x}", static_cast<std::uint64_t>(value), (field.width + 3) / 4);
    case Format::twos_complement:
    case Format::ones_complement: {
      const auto number = static_cast<std::uint64_t>(units_of(field, value));
      if (!bit(value, field.width - 1)) return show_size(field, number);
      return '-' + show_size(field, 0 - number);  // -0, too
    }
  }
  return {};
}

std::optional<Word> parse_short(const Field& field, std::string_view text) {
  for (std::size_t i = 0; i < field.named; ++i) {
    if (field.names[i] == text) return static_cast<Word>(i);
  }
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
  std::size_t longest = 0;
  for (std::size_t i = 0; i < field.named; ++i) {
    longest = std::max(longest, std::string_view(field.names[i]).size());
  }
  return std::max({longest, show_short(field, ones(field.width)).size(),
                   show_short(field, low_bits(most_negative, field.width)).size()});
}

}  // namespace cosim

#include "tb/show.h"

#include <fmt/format.h>

#include <algorithm>

namespace cosim {
namespace {

std::string digits(const Field& field, Word value) {
  return fmt::format("{:0{}b}", static_cast<std::uint64_t>(value), field.width);
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

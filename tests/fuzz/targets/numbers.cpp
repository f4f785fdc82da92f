// The words of the command line that are read as numbers: the same text as each kind.
#include "tb/cli/number.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <vector>

#include "tests/fuzz/expect.h"

namespace cosim::fuzz {
namespace {

const std::string option = "--option: ";
constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();

// The number without leading zeros is the text.
void check_digits(const std::string& text, std::uint64_t value) {
  const std::size_t zeros = std::min(text.find_first_not_of('0'), text.size() - 1);
  expect(text.substr(zeros) == std::to_string(value), "the digits are those of the number");
}

void check_whole(const std::string& text) {
  struct Range {
    std::uint64_t low, high;
  };
  for (const Range range : {Range{0, ~std::uint64_t{0}}, {1, 32}, {0, 0xffffffff}}) {
    std::uint64_t value = 0;
    const auto read = [&] { value = cli::whole("--option", text, range.low, range.high); };
    if (!accepted(option, read)) continue;
    expect(range.low <= value && value <= range.high, "the number is in its range");
    check_digits(text, value);
  }
}

// The same of a number that may have a minus sign.
void check_integer_digits(const std::string& text, std::int64_t value) {
  const bool minus = text.starts_with('-');
  expect(minus ? value <= 0 : value >= 0, "the sign is that of the number");
  const auto size = static_cast<std::uint64_t>(value);
  check_digits(text.substr(minus ? 1 : 0), minus ? 0 - size : size);
}

// As many numbers as there are ranges, each with its own.
void check_integers(const std::string& text) {
  constexpr std::int64_t most = 0xffffffff;
  const std::vector<cli::Range> some[] = {
      {{0, 0}},
      {{-most, most}},
      {{-largest, largest}},
      {{0, most}, {0, most}},
      {{-5, 5}, {-5, 5}, {-5, 5}, {1, 5}, {-5, 5}, {0, std::int64_t{1} << 57}}};
  for (const auto& ranges : some) {
    std::vector<std::int64_t> all;
    const auto read = [&] { all = cli::integers("--option", text, "A,B,C,D,E,F", ranges); };
    if (!accepted(option, read)) continue;
    expect(all.size() == ranges.size(), "there are as many numbers as ranges");
    std::istringstream parts(text);
    for (std::size_t i = 0; i < all.size(); ++i) {
      expect(ranges[i].low <= all[i] && all[i] <= ranges[i].high, "each number is in its range");
      std::string part;
      std::getline(parts, part, ',');
      check_integer_digits(part, all[i]);
    }
    expect(parts.eof(), "all of the text is read");
  }
}

void check_positive(const std::string& text) {
  constexpr double high = 1e9;
  double value = 0;
  if (!accepted(option, [&] { value = cli::positive("--option", text, high); })) return;
  expect(value > 0 && value <= high, "the number is in its range");
  expect(value == std::strtod(text.c_str(), nullptr), "the number is that of the C library");
}

}  // namespace

FUZZ_TARGET(numbers) {
  check_whole(text);
  check_integers(text);
  check_positive(text);
}

}  // namespace cosim::fuzz

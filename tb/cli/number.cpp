#include "tb/cli/number.h"

#include <fmt/core.h>

#include <charconv>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim::cli {

namespace {

template <class Number>
Number in_range(const std::string& name, const std::string& text, Number low, Number high) {
  Number value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || rest != end || value < low || value > high) {
    throw InputError(fmt::format("{}: {} is not a whole number from {} to {}", name,
                                 in_quotes(text), low, high));
  }
  return value;
}

}  // namespace

std::uint64_t whole(const std::string& name, const std::string& text, std::uint64_t low,
                    std::uint64_t high) {
  return in_range(name, text, low, high);
}

std::vector<std::int64_t> integers(const std::string& name, const std::string& text,
                                   const std::string& form, const std::vector<Range>& ranges) {
  std::vector<std::int64_t> all;
  std::size_t begin = 0, name_begin = 0;
  for (const Range& range : ranges) {
    const std::size_t comma = text.find(',', begin);
    const bool last = all.size() + 1 == ranges.size();
    if ((comma == std::string::npos) != last) {
      throw InputError(fmt::format("{}: {} is not {}", name, in_quotes(text), form));
    }
    const std::size_t name_end = form.find(',', name_begin);
    all.push_back(in_range(name + ": " + form.substr(name_begin, name_end - name_begin),
                           text.substr(begin, comma - begin), range.low, range.high));
    begin = comma + 1;
    name_begin = name_end + 1;
  }
  return all;
}

double positive(const std::string& name, const std::string& text, double high) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || rest != end || !(value > 0 && value <= high)) {
    throw InputError(
        fmt::format("{}: {} is not a number above 0 and at most {}", name, in_quotes(text), high));
  }
  return value;
}

}  // namespace cosim::cli

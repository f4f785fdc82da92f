#include "tb/cli/number.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>

#include "model/core/input_error.h"
#include "tb/support/words.h"

namespace cosim::cli {

std::uint64_t whole(const std::string& name, const std::string& text, std::uint64_t low,
                    std::uint64_t high) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || rest != end || value < low || value > high) {
    throw InputError(fmt::format("{}: {} is not a whole number from {} to {}", name,
                                 in_quotes(text), low, high));
  }
  return value;
}

std::int64_t integer(const std::string& name, const std::string& text, std::int64_t size) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || rest != end || value < -size || value > size) {
    throw InputError(fmt::format("{}: {} is not a whole number from {} to {}", name,
                                 in_quotes(text), -size, size));
  }
  return value;
}

std::vector<std::int64_t> integers(const std::string& name, const std::string& text,
                                   const std::string& form,
                                   const std::vector<std::int64_t>& sizes) {
  std::vector<std::int64_t> all;
  std::size_t begin = 0;
  for (const std::int64_t size : sizes) {
    const std::size_t comma = text.find(',', begin);
    const bool last = all.size() + 1 == sizes.size();
    if ((comma == std::string::npos) != last) {
      throw InputError(fmt::format("{}: {} is not {}", name, in_quotes(text), form));
    }
    all.push_back(integer(name, text.substr(begin, comma - begin), size));
    begin = comma + 1;
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

circular::Point point(const std::string& name, const std::string& text, std::uint64_t high) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos) {
    throw InputError(fmt::format("{}: {} is not X,Y", name, in_quotes(text)));
  }
  return {static_cast<std::int64_t>(whole(name + ": X", text.substr(0, comma), 0, high)),
          static_cast<std::int64_t>(whole(name + ": Y", text.substr(comma + 1), 0, high))};
}

}  // namespace cosim::cli

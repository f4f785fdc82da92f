// The variants of the RTL that hostile clocks find, and how short their stimulus becomes.
#pragma once

#include <cstddef>
#include <string>

namespace cosim::test {

/// A fault or a misprint, by the variant's name.
inline bool is_planted(const std::string& variant) {
  return variant.starts_with("faults/") || variant.starts_with("errata/");
}

/// Each is shrunk to at most so many clocks.
inline constexpr std::size_t most_clocks_shrunk = 12;

}  // namespace cosim::test

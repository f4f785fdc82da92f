// How a place in a text that a person hands in is named in an error.
#pragma once

#include <cstdint>
#include <string_view>

namespace cosim::toolpath {

/// A place in a text. Lines and columns count from 1; a column is a byte of its line, the
/// UTF-8 byte order mark at the head of a file not counted.
struct Place {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  friend bool operator==(const Place&, const Place&) = default;
};

/// Throws InputError "name:line:column: what". Control characters in `name` are shown as '?', so
/// that the text stays one line.
[[noreturn]] void fail(std::string_view name, Place place, std::string_view what);

}  // namespace cosim::toolpath

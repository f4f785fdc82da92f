// Values as a person reads them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/core/fields.h"

namespace cosim {

/// The shortest reading of a value: bits for a bit string, else the number they stand for. Bit
/// strings of more than 16 bits in hexadecimal.
std::string show_short(const Field& field, Word value);

/// The value that show_short gives as `text`; none where it gives no such text.
std::optional<Word> parse_short(const Field& field, std::string_view text);

/// The bits, and behind them what they stand for: "11110 (-1)".
std::string show(const Field& field, Word value);

/// The longest that show_short gets for the field.
std::size_t show_width(const Field& field);

}  // namespace cosim

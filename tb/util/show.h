// Values as a person reads them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/core/fields.h"

namespace cosim {

/// A value in its shortest form: the bits of a bit string, in hexadecimal above 16 bits, else the
/// number.
std::string show_short(const Field& field, Word value);

/// The value for which show_short gives `text`; none if there is none.
std::optional<Word> parse_short(const Field& field, std::string_view text);

/// The bits and the number they encode: "11110 (-1)".
std::string show(const Field& field, Word value);

/// The longest that show_short gets for the field.
std::size_t show_width(const Field& field);

}  // namespace cosim

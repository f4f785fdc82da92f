// JSON as a person writes it, with comments.
#pragma once

#include <string>
#include <vector>

#include "tb/support/json.h"

namespace cosim::regress {

/// The value in `text`. What is wrong is added to `errors`, with no place but the line and column
/// that it has: text that is no JSON, and keys that stand twice in an object, of which the library
/// would take the last.
Json parse(const std::string& text, std::vector<std::string>& errors);

}  // namespace cosim::regress

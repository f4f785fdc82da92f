// JSON, read and written. The library's reader and writer are compiled in this one place, for they
// take longer than most of what needs them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tb/support/json_fwd.h"

namespace cosim {

/// The value in `text`. Json::parse_error where it is no JSON.
Json json_of(const std::string& text);

/// The same, a discarded value (Json::is_discarded) where it is no JSON.
Json json_if(const std::string& text);

/// As text: on one line, or a line a value, each level `indent` spaces further in. A byte that is
/// no UTF-8 becomes a replacement character.
std::string json_text(const Json& json, int indent = -1);

/// On one line of ASCII, which can be cut anywhere.
std::string json_ascii(const Json& json);

}  // namespace cosim

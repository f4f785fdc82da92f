// JSON, read and written. The library's reader and writer are compiled in this one place, for they
// take longer than most of what needs them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tb/util/json_fwd.h"

namespace cosim {

/// How deep lists and objects may stand in one another where JSON is read.
inline constexpr int most_json_levels = 100;

/// The value in `text`, which may have comments, as a person writes it. What is wrong is added to
/// `errors`, with no place but the line and column that it has: text that is no JSON or has more
/// than most_json_levels, and keys that stand twice in an object, of which the library would take
/// the last.
Json parse_json(const std::string& text, std::vector<std::string>& errors);

/// The value in the text that this program or one that it runs has just made. Json::parse_error
/// where it is no JSON.
Json json_of(const std::string& text);

/// As text: on one line, or a line a value, each level `indent` spaces further in. A byte that is
/// no UTF-8 becomes a replacement character.
std::string json_text(const Json& json, int indent = -1);

/// On one line of ASCII of up to `longest` characters, for an error: where it is cut, "..."
/// follows.
std::string json_short(const Json& json, std::size_t longest);

}  // namespace cosim

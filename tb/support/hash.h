// A hash of text, against edits and mix-ups; not against who forges it.
#pragma once

#include <string>
#include <string_view>

namespace cosim {

/// 16 hexadecimal digits that follow from the bytes of `text` alone.
std::string hash_of(std::string_view text);

}  // namespace cosim

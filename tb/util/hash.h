// The hash of what is kept, against edits and mix-ups; not against who forges it: 128 bits of XXH3.
#pragma once

#include <string>
#include <string_view>

namespace cosim {

/// 32 hexadecimal digits that follow from the bytes of `text` alone.
std::string hash_of(std::string_view text);

/// The same of the bytes of a file of any size. InputError where it cannot be read.
std::string hash_of_file(const std::string& path);

/// That of this program's file: another build may have other cases, or other RTL.
const std::string& program_hash();

}  // namespace cosim

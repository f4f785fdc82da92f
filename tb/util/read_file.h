// The whole of a file that a person names.
#pragma once

#include <cstddef>
#include <string>

namespace cosim {

/// The largest file that read_file takes, in bytes.
inline constexpr std::size_t max_file_bytes = std::size_t{256} << 20;

/// The whole of a regular file, byte for byte. InputError for a directory, a pipe or a device, a
/// file that cannot be read and a file of more than max_file_bytes.
std::string read_file(const std::string& path);

}  // namespace cosim

// Files as texts, byte for byte.
#pragma once

#include <filesystem>
#include <string>

namespace cosim::rtl {

/// InputError, which calls the file `name`, where it cannot be read.
std::string text_of(const std::filesystem::path& file, const std::string& name);
inline std::string text_of(const std::filesystem::path& file) { return text_of(file, file); }
/// InputError where the file cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace cosim::rtl

// A file replaced at once: whoever reads it, and whenever its writer is killed, it holds the old
// text or the new one.
#pragma once

#include <string>

namespace cosim {

/// Writes `text` to a file of its own, `path` with ".cosim-new" behind it, and puts that in the
/// place of `path`, which is a regular file or does not exist. InputError where that fails; then
/// the old file stays.
void replace_file(const std::string& path, const std::string& text);

/// The text of a file. InputError where it cannot be read.
std::string text_of_file(const std::string& path);

}  // namespace cosim

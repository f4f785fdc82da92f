// A file replaced at once: whoever reads it, and whenever its writer is killed, it holds the old
// text or the new one.
#pragma once

#include <string>

namespace cosim {

/// Where a file can be replaced at once: the path behind all links. Empty for pipes, devices and
/// what a process has open, and where its folder takes no new file.
std::string replaceable(const std::string& path);

/// The name of the file that is to take the place of another.
std::string beside(const std::string& path);

/// Opens that file, empty and with the rights of the one whose place it takes, and gives its
/// number; -1 and errno where that fails.
int open_beside(const std::string& path);

/// Writes `text` to a file of its own, `path` with ".cosim-new" behind it, and puts that in the
/// place of `path`, which is a regular file or does not exist. InputError where that fails; then
/// the old file stays.
void replace_file(const std::string& path, const std::string& text);

}  // namespace cosim

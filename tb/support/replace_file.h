// Replaces a file at once: it always holds the whole old text or the whole new one, even if the
// writer is killed.
#pragma once

#include <string>

namespace cosim {

/// The path of the file after all links, if it can be replaced at once. Empty for pipes, devices
/// and files of /proc, and if no file can be made in its folder.
std::string replaceable(const std::string& path);

/// The name under which the replacement of a file is written.
std::string beside(const std::string& path);

/// Opens that file, empty and with the rights of the file it replaces, and returns its descriptor;
/// -1 and errno on failure.
int open_beside(const std::string& path);

/// Writes `text` to a file of its own, `path` with ".cosim-new" added, and renames it to
/// `path`, which is a regular file or does not exist. InputError if that fails; then the old file
/// stays.
void replace_file(const std::string& path, const std::string& text);

}  // namespace cosim

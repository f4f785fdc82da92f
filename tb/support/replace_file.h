// Replaces a file at once: it always holds the whole old text or the whole new one, even if the
// writer is killed.
#pragma once

#include <string>

namespace cosim {

/// The path of the file after all links, if it can be replaced at once. Empty for pipes, devices
/// and files of /proc, and if no file can be made in its folder.
std::string replaceable(const std::string& path);

/// A name under which the replacement of a file is written: FILE.NUMBER.cosim-new with another
/// random number each time, so that nothing has that name.
std::string beside(const std::string& path);

/// Makes the file of that name, with the rights of the file `path` that it replaces, and returns
/// its descriptor; -1 and errno on failure, also where something has that name.
int open_beside(const std::string& path, const std::string& name);

/// Writes `text` to a file of its own, and renames it to `path`, which is a regular file or does
/// not exist. InputError if that fails; then the old file stays.
void replace_file(const std::string& path, const std::string& text);

}  // namespace cosim

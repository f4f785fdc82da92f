// Files that Verilog names: what is read beside what a person names.
#pragma once

#include <string>
#include <vector>

namespace cosim::cli {

/// The files, and what they `include or give to $readmemh, and so on, wherever in their own
/// folders, in `folders` or in the working directory it may be found. What cannot be read is left
/// out.
std::vector<std::string> files_read(const std::vector<std::string>& files,
                                    const std::vector<std::string>& folders);

}  // namespace cosim::cli

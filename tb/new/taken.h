// Names that a field of a model cannot have.
#pragma once

#include <string>

namespace cosim::cli {

/// Whether it is a word of C++, such as `delete`, a macro, or what records have already.
bool is_taken(const std::string& name);

}  // namespace cosim::cli

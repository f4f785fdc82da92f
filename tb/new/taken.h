// Names that a design or one of its fields cannot have.
#pragma once

#include <string>

namespace cosim::cli {

/// The harness's header in which the name is declared; empty where it is in none.
std::string taken_by(const std::string& name);

/// Whether it is a word of the language, such as `delete`.
bool is_cpp_word(const std::string& name);

}  // namespace cosim::cli

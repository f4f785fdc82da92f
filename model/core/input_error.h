// The one error a person can cause: bad input. Its text is the single line shown to them.
#pragma once

#include <stdexcept>
#include <string>

namespace cosim {

/// Thrown for input a person can mend: a number out of range, a malformed file, an impossible arc.
/// `what()` is one complete line without a trailing newline, naming what is wrong and where
/// (for files "name:line:column: ..."). The command line prints it and exits with status 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& line) : std::runtime_error(line) {}
};

}  // namespace cosim

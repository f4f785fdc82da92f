// System tasks that print: they are no part of what RTL does, and yosys 0.23 does not read all of
// them.
#pragma once

#include <string>

namespace cosim::equiv {

/// A text of Verilog with blanks for its calls of $display and the like; all else, line breaks too,
/// stays where it is. Not within strings and comments.
std::string without_prints(std::string text);

}  // namespace cosim::equiv

// System tasks that print: they are no part of what RTL does, and yosys 0.23 does not read all of
// them.
#pragma once

#include <string>
#include <string_view>

namespace cosim::equiv {

/// A text of Verilog with blanks for its calls of $display and the like; all else, line breaks too,
/// stays where it is. Not within strings and comments.
std::string without_prints(std::string text);

/// Blanks in place of that piece of the text; line breaks stay.
void blank(std::string& text, std::size_t from, std::size_t to);
/// Behind the string or the comment that begins at `at`; `at` itself where none does.
std::size_t skipped(std::string_view text, std::size_t at);
/// Behind the arguments in brackets that begin at `at`, if some do.
std::size_t behind_arguments(std::string_view text, std::size_t at);

}  // namespace cosim::equiv

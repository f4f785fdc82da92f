// SystemVerilog without what adds nothing to what it does.
#pragma once

#include <string>

namespace cosim::equiv {

/// The text with blanks in place of concurrent assertions, of the properties and sequences that
/// they name, of default clocking and default disable: few readers know all of them. An assertion
/// that does more than print where it fails or holds stays. Places and lines stay.
std::string without_assertions(std::string text);

/// The text with blanks in place of `unique`, `unique0` and `priority` before `if` and `case`. A
/// simulator takes them for nothing; a front end takes an item that is not there for any value.
std::string without_unique(std::string text);

}  // namespace cosim::equiv

// What `verilator -E` writes.
#pragma once

#include <string>
#include <vector>

namespace cosim::rtl {

/// The text with all warnings on: without comments that turn one off, and with `always @*` for
/// always_latch, which says that a latch is meant. Each of `files`, by its name in the text's
/// lines, is read as Verilog-2005 if it ends in .v, and others as SystemVerilog; none: the text is
/// in one language.
std::string with_warnings(const std::string& text, const std::vector<std::string>& files);

}  // namespace cosim::rtl

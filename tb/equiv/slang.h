// slang, a reader of all SystemVerilog, where it is installed.
#pragma once

#include <string>

#include "tb/equiv/front_end.h"

namespace cosim::equiv {

/// What slang makes of a design, as elaborated().
Elaborated elaborated_by_slang(const Files& files, const std::string& what, const Budget& budget);

/// The design as plain Verilog that yosys 0.23 reads, as slang reads it: its parameters are
/// numbers, its nets and registers have their names. InputError and OutOfTime, as above.
std::string verilog_by_slang(const Files& files, const std::string& what, const Budget& budget);

/// Whether slang is there: `scripts/setup systemverilog` brings it. Another folder of npm's
/// packages, or a yosys that has read_slang, is named by COSIM_SLANG.
bool has_slang();

}  // namespace cosim::equiv

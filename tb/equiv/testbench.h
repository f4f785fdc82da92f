// A testbench that gives one of two RTLs the stimulus that tells them apart.
//
// A clock takes two microseconds: the inputs, a microsecond later the outputs are printed, then the
// clock goes there and back.
#pragma once

#include <string>

#include "tb/equiv/equiv.h"

namespace cosim::equiv {

/// What one clock takes, and how long after its beginning the outputs are what they are on it.
inline constexpr std::uint64_t clock_ps = 2'000'000, settled_ps = 1'000'000;

/// Verilog, the module cosim_replay with the RTL as its instance cosim_dut. It prints a line of
/// outputs a clock behind "cosim_replay", binary, as the old RTL calls them, in the order of
/// Row::gold; of the old RTL there follows a bit for each assumption, whether it holds. The inputs
/// of a clock are a line of the file `rows`, which is the other; with +cosim_wave it writes the
/// file `vcd` from clock `first` on.
std::string testbench(const Question& question, const Answer& answer, bool is_gate,
                      const std::string& rows, const std::string& vcd, std::uint64_t first);
std::string stimulus_rows(const Question& question, const Answer& answer, bool is_gate);

}  // namespace cosim::equiv

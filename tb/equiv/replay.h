// A stimulus that tells two RTLs apart, run again in Verilator on the RTL as it is written.
#pragma once

#include <string>

#include "tb/equiv/equiv.h"

namespace cosim::equiv {

struct Replay {
  bool shown = false;    ///< one of the outputs that differ does so on the last clock
  bool refuted = false;  ///< none does, though nothing is left to chance
  std::string how;       ///< "in Verilator", or on what else it was replayed, and why
};

/// Builds each RTL with a testbench that gives it the stimulus of a `different` answer. What has no
/// initial value begins as 0, as 1 and by chance, one run each. Takes as long as two compilers.
Replay replayed(const Question& question, const Answer& answer);

/// The testbench of one side, Verilog: a line of outputs a clock, binary, as the old RTL calls
/// them, in the order of Row::gold. The inputs of a clock are a line of the file `rows`, which is
/// the other.
std::string testbench(const Question& question, const Answer& answer, bool is_gate,
                      const std::string& rows);
std::string stimulus_rows(const Question& question, const Answer& answer, bool is_gate);

}  // namespace cosim::equiv

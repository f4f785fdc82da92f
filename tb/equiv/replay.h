// A stimulus that tells two RTLs apart, run again in Verilator on the RTL as it is written.
#pragma once

#include <string>
#include <vector>

#include "tb/equiv/equiv.h"

namespace cosim::equiv {

/// What one RTL does in Verilator.
struct Shown {
  std::vector<std::vector<std::string>> outputs;  ///< a row a clock, in the order of Row::gold
  std::string vcd;                                ///< the file of the wave, from Replay::first on
};

struct Replay {
  bool shown = false;    ///< one of the outputs that differ does so on the last clock
  bool refuted = false;  ///< none does, though nothing is left to chance
  std::string how;       ///< "in Verilator", or on what else it was replayed, and why
  Shown gold, gate;      ///< where it is shown
};

/// Builds each RTL with a testbench that gives it the stimulus of a `different` answer, and the
/// clocks after it. What has no initial value begins as 0, as 1 and by chance, one run each. Takes
/// as long as two compilers.
Replay replayed(const Question& question, const Answer& answer);

}  // namespace cosim::equiv

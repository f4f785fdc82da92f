// A stimulus that tells two RTLs apart, run again in a simulator on the RTL as it is written.
#pragma once

#include <string>
#include <vector>

#include "tb/equiv/equiv.h"

namespace cosim::equiv {

/// What one RTL does.
struct Shown {
  std::vector<std::vector<std::string>> outputs;  ///< a row a clock, in the order of Row::gold
  std::string vcd;                                ///< the wave, from first_drawn() on
};

struct Replay {
  bool shown = false;    ///< one of the outputs that differ does so on the last clock
  bool refuted = false;  ///< none does, though nothing is left to chance
  std::string how;       ///< "in Icarus Verilog", or on what else it was replayed, and why
  std::string why;       ///< of `refuted`: what is seen in place of a difference
  Shown gold, gate;      ///< where it is shown
};

/// Gives each RTL the stimulus of a `different` answer, and the clocks after it: in Icarus Verilog,
/// where registers begin as they do in the answer, and else in Verilator, where what has no initial
/// value begins as 0, as 1 and by chance, one run each. An output that the old RTL leaves x differs
/// from nothing; an x of the new RTL differs from what is not x.
Replay replayed(const Question& question, const Answer& answer);

}  // namespace cosim::equiv

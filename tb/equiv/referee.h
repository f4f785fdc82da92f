// Whether a netlist is what its source says: both run side by side, the source in a simulator that
// read it by itself. No verdict rests on what one reader alone says.
//
// Registers without an initial value are given one in both, so that an x is one of the source. The
// netlist runs 64 times at once, with other values for what is not known in each. Where the source
// is 0 or 1, all of them must say so; where the source of the new RTL is x though its registers are
// known, they must not all say the same, for such an x would be taken for what is convenient.
#pragma once

#include <map>
#include <string>

#include "tb/equiv/side.h"

namespace cosim::equiv {

struct Refereed {
  bool agrees = false;
  std::string by;  ///< "Icarus Verilog"; empty where no simulator has run it
  int clocks = 0;  ///< that were compared
  std::string
      wrong;  ///< one line: what differs, on which clock, both values; or why it did not run
};

struct Referee {
  bool steps = false;                  ///< clocks are inputs
  std::map<std::string, bool> resets;  ///< inputs that reset, and the level
  bool x_matters = false;              ///< it is the new RTL
  bool verilator = true;               ///< may be used, where Icarus cannot read the source
  std::chrono::steady_clock::time_point until;
};

/// Compares the gates of a side, which were made, with its source: outputs and registers.
Refereed refereed(const Side& side, const Referee& how);

}  // namespace cosim::equiv

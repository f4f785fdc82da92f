// What is assumed of the ports: expressions of Verilog that are true on every clock after the
// reset.
#pragma once

#include <string>
#include <vector>

#include "tb/equiv/side.h"

namespace cosim::equiv {

struct Assumption {
  std::string text;                ///< as it was given
  Side logic;                      ///< the module below as gates: its inputs are ports
  std::string verilog;             ///< the module `name`, with the output cosim_holds
  std::string name;                ///< of no other one
  std::vector<std::string> ports;  ///< of the old RTL, that it names
  bool of_outputs = false;         ///< some are outputs: those of the old RTL
};

/// InputError "--assume: ...", one line, where a text is no expression of Verilog, names what is no
/// port of `gold`, or names the clock. OutOfTime.
std::vector<Assumption> assumptions(const std::vector<std::string>& texts, const Side& gold,
                                    const Budget& budget);

struct Question;
/// InputError where no stimulus keeps to the question's assumptions: anything would be equal then.
/// Those of inputs alone are looked at for all clocks, others for the first 20 after the reset.
/// False where it is not known. To be called when the gates are made.
bool are_met(Question& question);

}  // namespace cosim::equiv

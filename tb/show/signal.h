// A signal of a running simulation, to be looked at on every clock.
#pragma once

#include <string>
#include <vector>

#include "model/core/value.h"

namespace cosim {

struct Signal {
  std::vector<std::string> scope;  ///< the instances from the top module down to its own
  std::string name;
  int width = 1;  ///< bits
  /// Its bits, the lowest byte first; valid as long as the simulation lives.
  const unsigned char* bytes = nullptr;
  int word = -1;          ///< of a word of a memory its number; its name has it too
  bool is_clock = false;  ///< it is high from the beginning of a clock to its middle
  /// Of one of several clocks: 0 on a step on which it does not take its edge. Null: it always
  /// does.
  const Word* takes_edge = nullptr;
  bool falls = false;   ///< that is its falling edge: it is low for so long
  std::string range{};  ///< "[7:4]"; "" where they are counted from 0
};

}  // namespace cosim

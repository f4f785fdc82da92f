// A signal of a running simulation, to be looked at on every clock.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cosim {

struct Signal {
  std::vector<std::string> scope;  ///< the instances from the top module down to its own
  std::string name;
  int width = 1;  ///< bits
  /// Its bits, the lowest byte first; valid as long as the simulation lives.
  const unsigned char* bytes = nullptr;
  int word = -1;          ///< of a word of a memory its number; its name has it too
  bool is_clock = false;  ///< it is high from the beginning of a clock to its middle
};

}  // namespace cosim

// The registers in a netlist of yosys: their bits, their clock and their asynchronous reset.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tb/support/json.h"

namespace cosim::cli {

/// InputError "new: ...".
[[noreturn]] void refuse(const std::string& why);

/// Bits of a net by their numbers; a constant bit is -1.
std::vector<int> bits_of(const Json& list);
/// The name of a bit of the module, for a person.
std::string name_of(const Json& module, int bit);
/// The memory that a cell writes or reads.
std::string memory_of(const Json& cell);

struct Held {
  std::set<int> bits;
  int clock = -1;  ///< its bit; -1: there is none
  struct Reset {
    int bit = -1;
    bool active_low = false;
  } reset;  ///< asynchronous, one or none
};
/// InputError where there are two clocks or resets, or what no clock holds.
Held held(const Json& module);

}  // namespace cosim::cli

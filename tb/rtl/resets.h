// What a reset gives to the registers, told from the text of their processes: constants are carried
// through conditions that the reset decides (constant propagation).
#pragma once

#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "tb/rtl/elaborated.h"

namespace cosim::rtl {

/// Inputs, and registers that reset others, with the level at which each resets.
using Levels = std::map<std::string, bool>;

struct Resets {
  Levels asynchronous;  ///< inputs
  Levels inner;         ///< registers
};

/// Prints the lines synchronous, given and value of registers.h. `wanted`: the name of the
/// synchronous reset, "" where it is to be found.
void print_resets(const Elaborated& design, const std::string& wanted, const Resets& resets,
                  const std::vector<std::string>& registers, std::ostream& out);

}  // namespace cosim::rtl

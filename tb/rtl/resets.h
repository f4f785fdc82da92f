// What a reset gives to the registers, told from the text of their processes: constants are carried
// through conditions that the reset decides (constant propagation).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tb/rtl/elaborated.h"
#include "tb/rtl/registers.h"

namespace cosim::rtl {

/// Inputs, and registers that reset others, with the level at which each resets.
using Levels = std::map<std::string, bool>;

struct Resets {
  Levels asynchronous;  ///< inputs
  Levels inner;         ///< registers
};

/// Adds the resets, with the constants that they give, and the values of the registers. `wanted`:
/// the name of the synchronous reset, "" where it is to be found.
void find_resets(const Elaborated& design, const std::string& wanted, const Resets& resets,
                 Registers& found);

}  // namespace cosim::rtl

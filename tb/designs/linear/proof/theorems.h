// What SU 1631518 claims of its machine.
#pragma once

#include "tb/proof/theorems.h"

namespace cosim::linear {

/// What a code gives, for every BP of up to 32 bits.
std::vector<proof::Theorem> code_theorems();
/// From the pins to the words: every shipped width.
std::vector<proof::Theorem> word_theorems();

}  // namespace cosim::linear

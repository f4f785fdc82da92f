// A difference as a wave: both RTLs side by side, the old one above the new one.
#pragma once

#include <cstdint>
#include <string>

#include "tb/equiv/equiv.h"
#include "tb/show/picture.h"

namespace cosim::equiv {

/// Draws the clocks around the difference into the file `fst`, with its view, and returns the
/// picture. The hierarchies of both are in it, as old.* and new.*, where Verilator recorded them.
/// A bit that the old RTL leaves x is drawn as the new one has it; a word that is x in all its bits
/// counts as not compared, and so do the clocks of the reset. `after`: clocks behind the
/// difference. InputError where it cannot be written.
WavePicture draw(const Question& question, const Answer& answer, std::uint64_t after,
                 const std::string& fst);

}  // namespace cosim::equiv

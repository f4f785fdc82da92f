// Mutants drawn at random of those that lanes killed, for the ordinary lockstep to kill again.
#pragma once

#include <filesystem>

#include "tb/mutation/subject.h"
#include "tb/mutation/verilated.h"

namespace cosim::mutation {

/// Draws `count` mutants that a quick case kills, or all where these are fewer. Writes into the
/// folder mutants.v, which has them, and drawn.json: an array of objects with `mutant`, `what`,
/// `stimulus`, `clock`, `signal`, and `cleared`, false where what a reset leaves depends on how the
/// RTL powered up.
void draw(const Subject& subject, std::size_t count, const std::filesystem::path& folder);

/// Runs the mutants of that list in the Verilated class: each must be killed by the same case, on
/// the same clock, at the same signal; one that is not reset, which powers up otherwise there, by
/// any quick case. Prints the others and how many there were. The exit status.
int check_drawn(const VerilatedMutants& mutants, const std::filesystem::path& folder);

}  // namespace cosim::mutation

// The stimulus of a difference, clock by clock, as words of ports.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tb/equiv/product.h"
#include "tb/equiv/replay.h"
#include "tb/proof/reach.h"

namespace cosim::equiv {

/// What the new RTL calls a port of the old one.
std::string gate_name(const Question& question, const std::string& port);
/// What the old RTL calls a port of the new one.
std::string gold_name(const Question& question, const std::string& port);

/// A bit of an input, by the old name, that has a value; none where it is free.
std::optional<bool> tied_bit(const Question& question, const Name& name);

/// Makes the answer `different`: the clocks that `reached` has and those after them. `open`: bits
/// of outputs that other values of the old RTL's x would make others.
void show(const Question& question, const Product& product, const proof::Reached& reached,
          const std::set<Name>& open, Answer& answer);

/// Puts what Verilator has shown in place of what the netlists do.
void take_over(const Question& question, const Replay& replay, Answer& answer);

/// The outputs that differ on one of the clocks, if all of them have the same values in the same
/// order, the one that differs first too; else none. What only one of both has come to when the
/// clocks end is not held against them.
std::vector<Late> late_outputs(const Question& question, const Answer& answer);

}  // namespace cosim::equiv

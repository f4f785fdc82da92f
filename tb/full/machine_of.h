// What is known of a bench's RTL and of its formulas.
#pragma once

#include "tb/bench/bench.h"
#include "tb/proof/claims.h"
#include "tb/proof/machines.h"

namespace cosim::cli {

/// What is known of a bench's RTL and of its formulas. InputError where nothing is.
const proof::BuiltMachine& machine_of(const AnyBench& bench);

/// The RTL that a bench was built from, with its parameters.
proof::Source source_of(const AnyBench& bench);

/// RTL as it is read for claims on a machine, whose formula decides which of the RTL's registers
/// are kept and how it is reset.
proof::Source source_for(const proof::MachineFormula& machine, proof::Source source);

}  // namespace cosim::cli

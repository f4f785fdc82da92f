// What is known of a bench's RTL and of its formulas.
#pragma once

#include <vector>

#include "tb/bench/bench.h"
#include "tb/proof/claims.h"
#include "tb/proof/machines.h"

namespace cosim::cli {

/// What is known of a bench's RTL and of its formulas. InputError where nothing is.
const proof::BuiltMachine& machine_of(const AnyBench& bench);

/// The RTL that a bench was built from, with its parameters.
proof::Source source_of(const AnyBench& bench);

/// All that is claimed of a machine and its RTL, by yosys. Its formula decides which of the RTL's
/// registers are kept and how it is reset. InputError as of proof::Rtl and of the claims.
std::vector<proof::Claim> claims_on(const proof::MachineFormula& machine, const nets::Model& nets,
                                    proof::Source source);

}  // namespace cosim::cli

// The proof on a mutant: RTL in which one of many small faults is turned on by an input.
#pragma once

#include "tb/proof/claims.h"

namespace cosim::proof {

/// The claims of tb/proof/claims.h on RTL whose input `mutsel` is `number`. A mutant's flip-flop
/// need not be what a register's net shows, so nothing is said of the flip-flops: they may hold
/// anything with which the nets of the registers hold what they are to hold, and after the clock
/// the nets are to do so again. InputError where the RTL has no such nets.
Claim mutant_clear(const MachineFormula& machine, const Rtl& rtl, unsigned number);
Claim mutant_step(const MachineFormula& machine, const Rtl& rtl, unsigned number);

}  // namespace cosim::proof

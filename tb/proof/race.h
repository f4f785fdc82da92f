// Engines on claims side by side: who is asked what next, and who is stopped.
//
// A question goes to as many engines as must agree, and each try has a slice of time. What a slice
// did not decide goes to another engine, and then to all of them anew with four times the time; so
// one that never answers holds up none that would (a portfolio, as of SAT solvers). Where a thread
// has nothing else to do the other engines begin at once. Who has not answered when enough have is
// stopped.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "tb/proof/decide.h"

namespace cosim::proof {

/// Told of each claim what the engines said, in the order of asking.engines; those that were
/// stopped before they said anything are left out.
using ToldClaim = std::function<void(std::size_t claim, std::vector<Opinion>)>;

/// Tells each claim as soon as nobody is to be asked of it any more, one at a time.
void race(const std::vector<const Claim*>& claims, const Asking& asking, std::size_t needed,
          const ToldClaim& told);

}  // namespace cosim::proof

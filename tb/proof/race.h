// Engines on claims side by side: who is asked what next, and who is stopped.
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

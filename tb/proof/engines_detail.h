// What the engines have in common.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "tb/proof/engines.h"

namespace cosim::proof {

Solved solve_by_abc(const Questions& questions, int limit, const std::atomic<bool>* no_more);
Solved solve_by_cadical(const Questions& questions, int limit, const std::atomic<bool>* no_more);

/// Tries what an engine found: the inputs, a number each, 0 or 1. Where `asked` is not 1 then, the
/// engine has failed, and the answers go; else the values of the terms are those of the first time.
bool take(const Questions& questions, nets::Bit asked, const std::vector<std::uint64_t>& inputs,
          Solved& solved);

}  // namespace cosim::proof

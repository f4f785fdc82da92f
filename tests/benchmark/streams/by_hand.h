// A scoreboard for the filter as it is written by hand with cocotb: a coroutine each that drives
// and that watches an interface, a model of one sample at a time, a queue of what must come out.
#pragma once

#include <cstddef>
#include <vector>

class VfirW12STAGES3;

namespace by_hand {

/// What one case gives: samples, the clocks before each, the clocks before each result is taken,
/// and whether it is not taken before valid was seen either.
struct Case {
  std::vector<int> samples;
  std::vector<int> stalls, waits;
  std::vector<bool> sees_valid;
};

/// Runs it from a reset on. How many results came and were right; the first wrong one ends it.
std::size_t run(VfirW12STAGES3& top, const Case& given);

}  // namespace by_hand

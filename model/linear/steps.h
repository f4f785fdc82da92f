// What the linear machine's words say: the steps of a clock.
#pragma once

#include <bit>

#include "model/linear/machine.h"

namespace cosim::linear {

/// Calls take(dx, dy) for each step of a clock, the first one first: x along the major axis, which
/// makes every step.
template <class Take>
void for_each_step(const Params& p, const Outputs<Word>& out, Take take) {
  for (int i = p.word() - 1; i >= 0; --i) {
    if (bit(out.major, i)) take(Word{1}, Word{bit(out.minor, i)});
  }
}

/// How far a clock's steps go.
struct Way {
  Word x = 0;
  Word y = 0;
};
inline Way way_of(const Outputs<Word>& out) {
  return {std::popcount(static_cast<std::uint64_t>(out.major)),
          std::popcount(static_cast<std::uint64_t>(out.minor))};
}

}  // namespace cosim::linear

// The exact definition of the linear machine's points, with no state of a machine.
#pragma once

#include <cstdint>

#include "model/linear/control_code.h"

namespace cosim::linear {

/// True where the minor axis steps on elementary position q >= 1: a_i with q = 2^(i-1) * odd,
/// false where i > m.
bool minor_steps_at(int m, Code code, std::int64_t q);

/// The pair of words of one tick, bit 2^gamma - 1 being the tick's first position (leftmost).
struct Words {
  std::uint64_t major = 0;
  std::uint64_t minor = 0;
  friend bool operator==(const Words&, const Words&) = default;
};

/// The words of tick k = 0, 1, ... of a line: positions k * 2^gamma + 1 .. (k + 1) * 2^gamma, those
/// past BP being 0 on both axes. 0 <= gamma <= 6; both words are 0 outside these ranges.
Words words_at(int m, int gamma, const Line& line, std::int64_t tick);

/// ceil(BP / 2^gamma), 0 <= gamma <= 6; 0 for any other gamma or a negative BP.
std::int64_t ticks(int gamma, std::int64_t major);

/// How far (x, y) is off the straight line from (0, 0) to (major, minor), across it, in steps; 0
/// where that line is a point. All of at most 32 bits.
double deviation(std::int64_t major, std::int64_t minor, std::int64_t x, std::int64_t y);

}  // namespace cosim::linear

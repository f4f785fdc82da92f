// The line that the linear machine draws worst with the best control code.
#pragma once

#include "model/linear/control_code.h"

namespace cosim::claims {

struct WorstLine {
  std::int64_t major = 0;
  linear::Code code = 0;
  double deviation = 0;  ///< the largest along the minor axis, in steps, exact but for the division
};

/// Over all lines of m bits. Takes 3 s at 12 bits and four times as long for each bit more.
WorstLine worst_of_all(int m);

/// The same by walking the line's positions in the oracle.
double walked_deviation(int m, const WorstLine& line);

/// The worst that a search finds, 8 <= m <= 32; no line is known that is worse. The deviation at
/// position q is the sum over the bits a_i of the code of a_i (r_i(q) - q / BP * r_i(BP)), where
/// r_i(x) = floor(x / 2^i + 1/2) - x / 2^i. It is large where r_i(q) and r_i(BP) are near 1/3 and
/// of different signs for every other i, which makes BP and the code 0101... but for their ends. So
/// the search takes every head of 5 bits and tail of 3 around such a middle. Flipping one or two
/// bits of what it finds makes it no worse, and all lines of 16 bits, tried once, have no worse
/// one.
WorstLine worst_found(int m);

}  // namespace cosim::claims

// The table of the largest error of a line by its bits.
#pragma once

namespace cosim::claims {

/// Prints it in Markdown. False, with a line on standard error, where a figure is not what another
/// way to it gives: all lines at 8, 10 and 12 bits, the oracle's positions up to 24 bits, and the
/// growth that the sum of worst_line.h allows.
bool print_line_table();

}  // namespace cosim::claims

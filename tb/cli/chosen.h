// The built machines that the words of a command line choose: none of them, a design, or a design
// and values of its parameters, as `list` prints them: NAME M=5 N=2.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "tb/sim/bench.h"

namespace cosim::cli {

/// All benches of the design that is the first word, with the parameters that the others give; all
/// there are where there is no word, but for those that cannot be used, which are left out.
/// InputError where there is none.
std::vector<const AnyBench*> chosen_benches(const std::vector<std::string>& words);

/// The same, one bench of each shape, for what asks of the RTL alone.
std::vector<const AnyBench*> chosen_shapes(const std::vector<std::string>& words);

/// The first of those that the first words choose, a design and values of its parameters, and how
/// many words these are. Others may follow. InputError where there is none.
std::pair<const AnyBench*, std::size_t> bench_before(const std::vector<std::string>& words);

/// A design that a command for all of them has to leave out: `line` says why, on standard error.
/// The program then does not end with 0.
void leave_out(const std::string& line);
bool was_left_out();

}  // namespace cosim::cli

// The clocks of RTL: the inputs on whose edges its registers change.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tb/rtl/elaborated.h"

namespace cosim::rtl {

/// InputError where its registers change on both edges of one net.
void require_one_edge(const Elaborated& design, const Process& p);

/// All of them, by name. InputError where it cannot be told which edge of a process is the clock's.
std::vector<std::string> found_clocks(const Elaborated& design);

/// Gives each process its clock, one of those, and leaves its other edges: the way of each clock,
/// POS or NEG. InputError where a process has none of them, where two take other edges of one, and
/// on a falling edge if it is to be one rising clock.
std::map<std::string, std::string> give_clocks(Elaborated& design,
                                               const std::vector<std::string>& clocks, bool is_one);

/// InputError where a clock is more than one: of several, what is worked out from one is another
/// thing before its edge and after it.
void require_plain(const Elaborated& design, const std::string& clock);

}  // namespace cosim::rtl

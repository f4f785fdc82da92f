// What holds of every run, whatever was asked of it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/careless/run.h"

namespace cosim::careless {

using Held = std::map<std::string, std::string>;

/// What does not hold, a line each. `before` and `after`: what the scratch folder held.
std::vector<std::string> faults(const Case& one, const Came& came, const Scratch& scratch,
                                const Held& before, const Held& after);

/// Why a file that was written is not whole, or holds a figure that is none; empty where it is. It
/// is judged by what it begins with and by its name.
std::string unsound(const std::string& path);

}  // namespace cosim::careless

// What yosys writes of a module, as text.
#pragma once

#include <string>

#include "tb/support/json_fwd.h"

namespace cosim::equiv {

/// The module that a netlist of one has, as JSON.
const Json& top_of(const Json& netlist);
Json& top_of(Json& netlist);

/// RTLIL without what says nothing of what it does: its name, where it comes from, and the names
/// that yosys made, which are numbered in the order in which they are met. Modules whose forms are
/// the same text are the same.
std::string form_of(const std::string& rtlil);

}  // namespace cosim::equiv

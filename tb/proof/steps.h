// RTL of several clocks as RTL of one: a step.
#pragma once

#include <filesystem>
#include <string>

#include "tb/proof/yosys.h"

namespace cosim::proof {

/// For yosys, behind what makes one module of `source` without memories and before async2sync: the
/// commands, each with "; " before it, after which every flip-flop takes its next value on each
/// step. None where the source has one clock. The file that they need is written into `folder`.
std::string step_commands(const Source& source, const std::filesystem::path& folder);

}  // namespace cosim::proof

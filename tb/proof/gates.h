// The cells of yosys as gates.
#pragma once

#include <filesystem>
#include <string>

namespace cosim::proof {

/// For yosys: the command, with "; " before it, that makes gates of all cells but flip-flops. The
/// file that it needs is written into `folder`.
std::string gate_commands(const std::filesystem::path& folder);

}  // namespace cosim::proof

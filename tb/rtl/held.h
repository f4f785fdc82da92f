// What RTL holds, by the flat netlist that yosys wrote of it behind `proc; flatten`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cosim::rtl {

/// Bit `bit` of a net of `width` bits.
struct NamedBit {
  std::string net;
  long bit = 0, width = 0;
};

/// What an output depends on.
struct Held {
  std::vector<std::vector<NamedBit>> registers = {};  ///< each bit by all its names
  std::vector<std::vector<NamedBit>> latches = {};    ///< likewise
  std::vector<std::string> memories = {};             ///< that are written
};

/// InputError where the file is no JSON of yosys, or has no top.
Held read_held(const std::filesystem::path& file);

}  // namespace cosim::rtl

// How SystemVerilog declares its unpacked arrays, which its netlist no longer tells.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cosim::proof {

enum class Order {
  upward,    ///< logic [7:0] held [2], held [0:1]: element 0 has the highest bits of its net
  downward,  ///< held [1:0]: it has the lowest
  both       ///< one is declared so and another otherwise
};

/// By their names; those of one dimension, which have their type before them.
std::map<std::string, Order> declared_arrays(const std::vector<std::filesystem::path>& files);

}  // namespace cosim::proof

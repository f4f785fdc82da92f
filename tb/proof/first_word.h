// Where yosys has made wires of a memory's words: from which word on.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>

namespace cosim::proof {

/// The smallest number that stands behind `begins` in the names of `wires`, a map that is ordered
/// by them; 0 where no name begins so.
template <class Wires>
int first_word(const Wires& wires, const std::string& begins) {
  std::optional<int> first;
  for (auto wire = wires.lower_bound(begins);
       wire != wires.end() && wire->first.starts_with(begins); ++wire) {
    const int number = std::atoi(wire->first.c_str() + begins.size());
    first = std::min(first.value_or(number), number);
  }
  return first.value_or(0);
}

}  // namespace cosim::proof

// A stimulus: the inputs of every clock and where they start from, all that a run needs. As a text
// it is in bench/stimulus_text.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/core/fields.h"

namespace cosim {

struct Stimulus {
  std::string machine;         ///< AnyBench::title() of the bench it is for
  std::string origin;          ///< what it came from, one line; may be empty
  std::uint32_t power_up = 1;  ///< the RTL's registers at power-up
  /// The model's state to start from, in the order of its table; none: after a reset.
  std::optional<std::vector<Word>> state;
  std::vector<std::vector<Word>> clocks;  ///< the inputs of each clock, in the order of their table
};

}  // namespace cosim

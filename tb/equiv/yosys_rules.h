// What yosys's messages mean.
#pragma once

#include <string>
#include <vector>

#include "tb/util/pattern.h"

namespace cosim::equiv {

struct Rule {
  Pattern pattern;   ///< of a message, with names as a person writes them
  std::string text;  ///< in its place: $1 as in Pattern, {signal} and its {reset}
};

/// The first that fits holds.
const std::vector<Rule>& yosys_rules();

}  // namespace cosim::equiv

// What is claimed of a design beyond its RTL, as theorems on its golden model. A design brings them
// by defining std::vector<Theorem> cosim::DESIGN::theorems() in tb/designs/DESIGN/proof.
#pragma once

#include <string>
#include <vector>

#include "tb/proof/claims.h"

namespace cosim::proof {

struct Theorem {
  std::string design;
  std::string sentence;  ///< for a person, whole
  Claim claim;           ///< its negation cannot be
  Claim premises;        ///< what it assumes can be: it says something
};

/// Those of all designs; made by CMake.
std::vector<Theorem> theorems();

/// Several lists as one.
std::vector<Theorem> joined(std::vector<std::vector<Theorem>> lists);

}  // namespace cosim::proof

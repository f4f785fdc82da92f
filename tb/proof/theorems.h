// What the sources claim of their machines, as theorems on the golden models.
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

/// Integers without end: every radius and every width.
std::vector<Theorem> circular_theorems();
/// Integers without end, and every shipped width where a word is meant.
std::vector<Theorem> linear_theorems();

}  // namespace cosim::proof

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

/// All of them.
std::vector<Theorem> theorems();

// By what they speak of. SU 1665343, on integers without end: every radius and every width.
std::vector<Theorem> circular_theorems();
/// The same, from the pins to the first point: every shipped width.
std::vector<Theorem> arc_theorems();
/// SU 1631518: what a code gives, for every BP of up to 32 bits.
std::vector<Theorem> code_theorems();
/// The same, from the pins to the words: every shipped width.
std::vector<Theorem> word_theorems();

}  // namespace cosim::proof

// Questions about gates: can a bit of a graph be 1?
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "model/core/value.h"
#include "tb/nets/graph.h"

namespace cosim::proof {

struct Questions {
  nets::Graph graph;
  std::vector<nets::Port> inputs;  ///< its free bits
  std::vector<nets::Port> asked;   ///< each bit with a few words
  /// The codes of what a counterexample shows, lowest bit first, by its terms (terms.h).
  std::map<std::string, std::vector<nets::Bit>> terms;
};

/// Each bit that is asked as binary AIGER, in the order of questions.asked, with the names of its
/// inputs.
std::vector<std::string> as_aiger(const Questions& questions);

}  // namespace cosim::proof

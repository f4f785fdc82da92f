// Claims put before the engines, several at a time. That something can never be is decided where
// all engines agree on each question; that it can be by one, whose answer is tried on the gates.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "tb/proof/claims.h"
#include "tb/proof/engines.h"

namespace cosim::proof {

/// What one engine says of a claim.
struct Opinion {
  Engine engine = Engine::cec;
  Solved solved{};
};

struct Decision {
  std::vector<Opinion> opinions;
  bool proved = false;    ///< all engines answered each question as wanted
  bool refuted = false;   ///< an engine gave an opposite answer, and none contradicts it
  bool disagree = false;  ///< the engines contradict each other
  std::string verdict;    ///< "proved", "REFUTED", or why it is neither
};

struct Asking {
  std::vector<Engine> engines = all_engines();
  int limit = 300;    ///< seconds of processor time for one answer
  unsigned jobs = 1;  ///< engines at a time
};

/// Told what came of a claim as soon as that is known, one at a time.
using Told = std::function<void(std::size_t claim, const Decision&)>;

/// Has the engines answer the claims. An engine is stopped where another has refuted the claim.
/// Results are in the order of the claims.
std::vector<Decision> decide(
    const std::vector<const Claim*>& claims, const Asking& asking,
    const Told& told = [](std::size_t, const Decision&) {});

/// Judges the opinions.
Decision judged(const Claim& claim, std::vector<Opinion> opinions);

/// Whether an engine reached its time limit, so that a longer one might help.
bool timed_out(const std::vector<Decision>& decisions);

/// What the terms of a refuted claim are in a counterexample; empty where there is none.
std::map<std::string, Word> refuting_values(const Decision& decision);

}  // namespace cosim::proof

// Claims put before the solvers, several questions at a time.
#pragma once

#include <string>
#include <vector>

#include "tb/proof/claims.h"

namespace cosim::proof {

/// What the solvers say of a claim.
struct Decision {
  std::vector<std::vector<Solved>> solved;  ///< by solver and query
  std::vector<double> seconds;              ///< of processor time, by solver, of all queries
  bool proved = false;                      ///< every solver answered every question as wanted
  bool refuted = false;  ///< a solver gave an opposite answer, and no solver a wanted one
  std::string verdict;   ///< "proved", "REFUTED", or why it is neither
};

/// Has every one of solvers() answer every query of the claims, `jobs` at a time, each for `limit`
/// seconds of processor time at most. Results are in the order of the claims.
std::vector<Decision> decide(const std::vector<const Claim*>& claims, int limit, unsigned jobs);

/// Whether a solver reached its time limit, so that a longer one might help.
bool timed_out(const std::vector<Decision>& decisions);

/// Judges the answers, by solver and query.
Decision judged(const Claim& claim, std::vector<std::vector<Solved>> solved);

}  // namespace cosim::proof

// What engines said of a claim, counted question by question.
#pragma once

#include <string>
#include <vector>

#include "tb/proof/decide.h"

namespace cosim::proof {

/// One engine's answers to one claim.
struct Summary {
  bool as_wanted = true;
  bool opposite = false;
  bool stopped = false;  ///< no more is known than that it was stopped
  std::string text;      ///< of the first answer that is not as wanted
};
Summary summary(const Claim& claim, const Opinion& opinion);

struct Votes {
  std::size_t least = 0;     ///< engines that answered a question as wanted, of that with fewest
  std::size_t against = 0;   ///< engines that gave an opposite answer
  bool conflict = false;     ///< one answered a question as wanted and one the opposite
  std::vector<bool> enough;  ///< by query: as many as are needed answered it as wanted
  bool settled = false;      ///< more answers would change nothing
};
/// What cec says it says of every query. `needed` engines must agree.
Votes votes_on(const Claim& claim, const std::vector<Opinion>& opinions, std::size_t needed);

const Solver& solver_of(Engine engine);

}  // namespace cosim::proof

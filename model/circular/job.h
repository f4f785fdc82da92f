// What the circular machine is given to do, SU 1665343: an arc; and what is due of it.
#pragma once

#include <string>
#include <vector>

#include "model/circular/arc.h"

namespace cosim::circular {

/// What the steps of an arc must come to.
struct Due {
  std::int64_t steps = 0;   ///< of the arc, or to where it is stopped
  bool is_whole = false;    ///< they lead to its end,
  std::int64_t end_y = 0;   ///< (0, end_y)
  std::int64_t excess = 0;  ///< x^2 + y^2 - R^2 at its start
};
Due due_of(const Arc& arc);

/// Simpler arcs to try in place of an arc that shows a fault, the simplest first. Each is smaller
/// in one respect and larger in none.
std::vector<Arc> smaller(const Arc& arc);
/// "R^2 = 144 from (12, 0)"
std::string describe(const Arc& arc);

}  // namespace cosim::circular

// Which of many things can ever happen, from reset? One stimulus may reach many of them.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <vector>

#include "tb/proof/reach.h"

namespace cosim::proof {

struct ReachedEach {
  struct Point {
    Ever ever = Ever::open;
    std::size_t stimulus = 0;  ///< of yes: the number of the first that reaches it
    int clocks = 0;            ///< of open: not in the first so many
  };
  std::vector<Point> points;
  /// Of each a row of inputs a clock; what the graph does on it has been run.
  std::vector<std::vector<std::vector<bool>>> stimuli;
};

/// Whether each of `points` is ever 1, as of reach(). Ends when it is `until`; `left` is told now
/// and then how many are not decided.
ReachedEach reach_each(const nets::Graph& graph, const nets::Bits& points,
                       std::chrono::steady_clock::time_point until, unsigned jobs,
                       const std::function<void(std::size_t)>& left);

}  // namespace cosim::proof

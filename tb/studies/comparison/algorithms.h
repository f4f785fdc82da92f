// The algorithms that are compared: those that are machines run in lockstep while they draw.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tb/designs/circular/design.h"
#include "tb/designs/dda/design.h"
#include "tb/designs/linear/design.h"
#include "tb/sim/bench.h"
#include "tb/studies/comparison/figures.h"
#include "tb/sweep/sweep.h"

namespace cosim::compare {

/// The machines at hand; one that the work does not need may be null.
struct Machines {
  const Bench<linear::Design>* linear = nullptr;
  const Bench<circular::Design>* circular = nullptr;
  const Bench<dda::Design>* dda = nullptr;
  std::uint32_t power_up = 1;
};

/// A path as it was drawn.
struct Drawing {
  Points points;             ///< the start, then a point a position
  std::uint64_t clocks = 0;  ///< from the start to the end; a word is one clock
  /// Of a machine: the bench, and what lockstep and the oracle say.
  const AnyBench* bench = nullptr;
  Result result;
};

/// How one algorithm draws one kind of work.
template <class Work>
struct Algorithm {
  std::string name;
  std::string what;  ///< a few words
  std::function<Drawing(const Machines&, const Work&)> draw;
  /// Whether it can do the work; where it is empty, it can do any.
  std::function<bool(const Work&)> can = {};
  std::string cannot = {};  ///< the work that it cannot do, a noun
};

const std::vector<Algorithm<Line>>& line_algorithms();
const std::vector<Algorithm<Arc>>& arc_algorithms();

}  // namespace cosim::compare

// What came of the points that no sweep reached, where an engine was asked for each whether it can
// ever happen.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tb/sim/bench.h"
#include "tb/sweep/points.h"

namespace cosim::coverage {

enum class Answer {
  reached,      ///< by a sweep, or by a stimulus of the engine that was run in the counted RTL
  unreachable,  ///< proved in every shape
  open,         ///< neither in the time there was
  not_asked,    ///< a line, or a bit that the RTL as nets does not have
};

/// Of the points of a design, in their order.
struct Answers {
  std::vector<Answer> places, cases;
};

struct Asking {
  struct Shape {
    const AnyBench* bench = nullptr;
    Points points;  ///< those that it has
  };
  std::vector<Shape> shapes;  ///< of one design
  int seconds = 60;           ///< for each of them, at the most
  std::string stimuli;        ///< a folder: each that reaches a point is left in it
  /// Runs stimuli, by their files, in the counted RTL of a shape; then all points as they are now.
  std::function<Points(const AnyBench& bench, const std::vector<std::string>& files)> run;
};

}  // namespace cosim::coverage
